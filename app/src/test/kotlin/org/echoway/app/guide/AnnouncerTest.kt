package org.echoway.app.guide

import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.app.testing.SamplePlan
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.Estimate
import org.echoway.core.TrackState
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test

class AnnouncerTest {
    private val announcer = Announcer()
    private var timeS = 0.0

    /** Keeps a state up for a while, as sixteen firings a second do. */
    private fun told(
        estimate: Estimate,
        seconds: Double = 1.0,
        belt: BeltHealth = SamplePlan.health(),
        line: Line = Line.OPEN,
    ): List<Message> = (0 until (seconds * 16).toInt()).flatMap {
        timeS += 1 / 16.0
        announcer.onState(SamplePlan.running(timeS, estimate, belt, line))
    }

    private val inOffice = SamplePlan.estimate(room = 0, x = 2.0, y = 1.0, headingDegrees = 90.0)
    private val inSeminar = SamplePlan.estimate(room = 1, x = 2.0, y = 1.0, headingDegrees = 90.0)
    private val lost = inOffice.copy(state = TrackState.LOST)

    private fun startInOffice() {
        told(inOffice, 2.0)
    }

    @Test fun theFirstFixNamesTheRoomOnce() {
        val searching = told(inOffice.copy(state = TrackState.SEARCHING), 3.0)
        assertEquals(listOf(Message.BeltBack, Message.Searching), searching)
        assertEquals(listOf(Message.RoomEntered(SamplePlan.office)), told(inOffice, 5.0).filterIsInstance<Message.RoomEntered>())
    }

    @Test fun anotherRoomIsToldWhenItHasSettled() {
        startInOffice()
        val wavering = (1..5).flatMap { told(inSeminar, 0.25) + told(inOffice, 0.25) }
        assertTrue(wavering.none { it is Message.RoomEntered })
        assertEquals(Message.RoomEntered(SamplePlan.seminar), told(inSeminar, 2.0).first())
    }

    @Test fun aDoorIsToldOnceAnApproach() {
        startInOffice()
        val near = SamplePlan.estimate(room = 0, x = 4.5, y = 2.0, headingDegrees = 0.0)
        val doors = told(near, 3.0).filterIsInstance<Message.DoorNear>()
        assertEquals(listOf(Direction.AHEAD), doors.map { it.seen.direction })
        told(inOffice, 1.0)
        assertEquals(1, told(near, 1.0).count { it is Message.DoorNear })
    }

    @Test fun theDoorOneCameThroughIsNotNews() {
        startInOffice()
        val justIn = SamplePlan.estimate(room = 1, x = 0.6, y = 2.0, headingDegrees = 120.0)
        assertTrue(told(justIn, 3.0).none { it is Message.DoorNear })
    }

    @Test fun positionLostIsToldWithinTwoSecondsAndToldAgainWhenItIsBack() {
        startInOffice()
        assertEquals(listOf(Message.Unsure), told(lost, 2.0))
        assertEquals(emptyList<Message>(), told(lost, 60.0))
        val found = told(inOffice, 1.0)
        assertEquals(Message.FoundAgain(SamplePlan.office, Direction.RIGHT), found.first { it is Message.FoundAgain })
    }

    @Test fun beltLostAndBack() {
        startInOffice()
        assertEquals(listOf(Message.BeltLost), told(inOffice, 5.0, SamplePlan.health(BeltLink.LOST)))
        assertEquals(listOf(Message.BeltBack), told(inOffice, 5.0).filter { it.topic == "belt" })
        assertEquals(listOf(Message.BeltLost), told(inOffice, 5.0, line = Line.GONE))
    }

    @Test fun silenceBeforeTheFirstBeltIsNotALoss() {
        assertEquals(emptyList<Message>(), told(inOffice, 5.0, BeltHealth.NONE, Line.WAITING))
    }

    @Test fun aBlockedSensorIsToldAndToldAgainWhenClear() {
        startInOffice()
        val blocked = told(inOffice, 3.0, SamplePlan.health(troubled = setOf(1)))
        assertEquals(listOf(Message.SensorBlocked(Side.FRONT_LEFT, 1)), blocked)
        assertEquals(listOf(Message.SensorClear(Side.FRONT_LEFT, 1)), told(inOffice, 3.0))
    }

    @Test fun manySensorsAtOnceAreOneLine() {
        startInOffice()
        assertEquals(listOf(Message.SensorsBlocked(4)), told(inOffice, 3.0, SamplePlan.health(troubled = setOf(1, 2, 3, 4))))
    }

    @Test fun lowBatteryIsToldOnceAndNotAtEveryFlicker() {
        startInOffice()
        val flicker = (1..10).flatMap { told(inOffice, 0.5, SamplePlan.health(batteryV = if (it % 2 == 0) 5.15 else 5.25)) }
        assertEquals(listOf(Message.BatteryLow), flicker)
    }

    @Test fun answersFollowWhatIsKnown() {
        assertEquals(Answer.NotRunning, announcer.whereAmI().answer)
        told(inOffice.copy(state = TrackState.SEARCHING, roomProbability = 0.7))
        assertEquals(Answer.Unsure(SamplePlan.office), announcer.whereAmI().answer)
        told(lost)
        assertEquals(Answer.Unsure(null), announcer.whereAmI().answer)
        told(inOffice, 1.0, line = Line.GONE)
        assertEquals(Answer.NoBelt(SamplePlan.office), announcer.whereAmI().answer)
        told(SamplePlan.estimate(room = 1, x = 3.0, y = 2.0, headingDegrees = 0.0))
        val here = announcer.whereAmI().answer as Answer.Here
        assertEquals(Direction.BEHIND, here.door?.direction)
        assertEquals(3.0, (here.facing as Facing.Wall).distanceM, 1e-9)
        assertEquals("Lectern", here.place?.name)
    }

    @Test fun aBuildingThatCannotBeOpenedIsToldOnce() {
        val failed = NavigationState.Failed("building.cfg:3: no such room")
        assertEquals(listOf(Message.CannotStart(failed.reason)), announcer.onState(failed))
        assertEquals(emptyList<Message>(), announcer.onState(failed))
    }
}
