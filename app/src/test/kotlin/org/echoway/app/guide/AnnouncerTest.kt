package org.echoway.app.guide

import org.echoway.app.engine.GuidanceEvent
import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.NoStart
import org.echoway.app.engine.Wish
import org.echoway.app.testing.SampleCues
import org.echoway.app.testing.SamplePlan
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.CueKind
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Estimate
import org.echoway.core.Start
import org.echoway.core.TrackState
import org.junit.Assert.assertEquals
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

    private fun startInOffice() {
        told(inOffice, 2.0)
    }

    @Test fun beltLostAndBack() {
        startInOffice()
        assertEquals(listOf(Message.BeltLost), told(inOffice, 5.0, SamplePlan.health(BeltLink.LOST)))
        assertEquals(listOf(Message.BeltBack), told(inOffice, 5.0))
        assertEquals(listOf(Message.BeltLost), told(inOffice, 5.0, line = Line.GONE))
    }

    @Test fun silenceBeforeTheFirstBeltIsNoLossButIsSaidOnce() {
        assertEquals(emptyList<Message>(), told(inOffice, 2.5, BeltHealth.NONE, Line.WAITING))
        assertEquals(listOf(Message.WaitingForBelt), told(inOffice, 60.0, BeltHealth.NONE, Line.WAITING))
        assertEquals(listOf(Message.BeltBack), told(inOffice, 5.0))
    }

    @Test fun aBlockedSensorIsToldAndToldAgainWhenClear() {
        startInOffice()
        val blocked = told(inOffice, 3.0, SamplePlan.health(troubled = setOf(1)))
        assertEquals(listOf(Message.SensorBlocked(Side.FRONT_LEFT, 1)), blocked)
        assertEquals(listOf(Message.SensorClear(Side.FRONT_LEFT, 1)), told(inOffice, 3.0))
    }

    @Test fun manySensorsAtOnceAreOneLine() {
        startInOffice()
        assertEquals(
            listOf(Message.SensorsBlocked(4)), told(inOffice, 3.0, SamplePlan.health(troubled = setOf(1, 2, 3, 4))),
        )
    }

    @Test fun lowBatteryIsToldOnceAndNotAtEveryFlicker() {
        startInOffice()
        val flicker =
            (1..10).flatMap { told(inOffice, 0.5, SamplePlan.health(batteryV = if (it % 2 == 0) 5.15 else 5.25)) }
        assertEquals(listOf(Message.BatteryLow), flicker)
    }

    @Test fun ofPositionAndWayItTellsWhatTheCoreSaysAndOfTheBeltItsOwn() {
        startInOffice()
        val turn = SampleCues.told(CueKind.TURN, "Turn left.", 90.0)
        assertEquals(listOf(Message.Told(turn.cue)), announcer.onEvent(turn))
        val belt = listOf(CueKind.BELT_LOST, CueKind.BELT_BACK, CueKind.BATTERY_LOW, CueKind.SENSOR_BLOCKED)
        assertEquals(emptyList<Message>(), belt.flatMap { announcer.onEvent(SampleCues.told(it, "twice")) })
    }

    @Test fun aRoomThatIsEnteredComesWithWhatIsNiceToKnow() {
        startInOffice()
        val entering = GuidanceEvent.Told(SampleCues.cue(CueKind.ENTERING, "Room 4, Seminar room.", room = 1))
        assertEquals(
            listOf(Message.Told(entering.cue), Message.RoomDetail(1, listOf("Lectern"))), announcer.onEvent(entering),
        )
    }

    @Test fun whatCannotBeGrantedIsSaid() {
        val refused = { wish: Wish -> announcer.onEvent(GuidanceEvent.Refused(wish, "for a log")) }
        assertEquals(listOf(Message.CannotLead(NoWay.NO_EXIT_KNOWN)), refused(Wish.LeadTo(Destination.WAY_OUT)))
        startInOffice()
        assertEquals(
            "an exit is known, but none is reached",
            listOf(Message.CannotLead(NoWay.NOT_REACHABLE)),
            refused(Wish.LeadTo(Destination.WAY_OUT)),
        )
        assertEquals(
            listOf(Message.CannotLead(NoWay.NOT_REACHABLE)), refused(Wish.LeadTo(Destination(DestinationKind.ROOM, 1))),
        )
        assertEquals(listOf(Message.CannotLead(NoWay.NOTHING_WALKED_YET)), refused(Wish.BackTrack))
        assertEquals(listOf(Message.NothingToRepeat), refused(Wish.Repeat))
    }

    @Test fun whatIsGrantedIsSaidWhereTheCoreDoesNotAnswerByItself() {
        startInOffice()
        val exit = Destination(DestinationKind.EXIT, 0)
        val granted = { wish: Wish -> announcer.onEvent(GuidanceEvent.Granted(wish)) }
        assertEquals(listOf(Message.LeadingBack), granted(Wish.BackTrack))
        assertEquals(listOf(Message.LeadingStopped), granted(Wish.StopLeading))
        assertEquals(listOf(Message.StartedAgain(SamplePlan.plan, exit)), granted(Wish.StandAt(Start(room = 0), exit)))
        assertEquals(emptyList<Message>(), granted(Wish.LeadTo(exit)) + granted(Wish.WhereAmI) + granted(Wish.Repeat))
        assertEquals(
            listOf(Message.CannotStandAt(SamplePlan.plan, exit)),
            announcer.onEvent(GuidanceEvent.Refused(Wish.StandAt(Start(room = 0), exit), "for a log")),
        )
        told(inOffice, 1.0, line = Line.GONE)
        val noBelt = Message.Unanswerable(NoAnswer.NoBelt(SamplePlan.office))
        assertEquals(
            "the way back is told once the belt is heard", listOf(Message.LeadingBack, noBelt), granted(Wish.BackTrack),
        )
    }

    @Test fun aBeltThatWasRefusedIsToldAndWhoAsksIsAskedAgain() {
        assertEquals(listOf(Message.BeltNotAllowed), told(inOffice, 5.0, BeltHealth.NONE, Line.PERMISSION_MISSING))
        assertEquals(NoAnswer.NotAllowed, announcer.withoutAnswer())
        assertEquals(listOf(Message.BeltRefused), told(inOffice, 5.0, BeltHealth.NONE, Line.REFUSED))
        assertEquals(NoAnswer.NotAllowed, announcer.withoutAnswer())
        assertEquals(
            "the answer said it", emptyList<Message>(), told(inOffice, 5.0, BeltHealth.NONE, Line.PERMISSION_MISSING),
        )
        assertEquals(
            "twice refused is told twice",
            listOf(Message.BeltRefused),
            told(inOffice, 5.0, BeltHealth.NONE, Line.REFUSED),
        )
        assertEquals(listOf(Message.BeltBack), told(inOffice, 5.0))
    }

    @Test fun theCoreAnswersWhileTheBeltIsHeard() {
        assertEquals(NoAnswer.NotRunning, announcer.withoutAnswer())
        startInOffice()
        assertEquals(null, announcer.withoutAnswer())
        told(inOffice, 1.0, line = Line.GONE)
        assertEquals(NoAnswer.NoBelt(SamplePlan.office), announcer.withoutAnswer())
        told(inOffice.copy(state = TrackState.LOST), 1.0, line = Line.GONE)
        assertEquals(NoAnswer.NoBelt(null), announcer.withoutAnswer())
    }

    @Test fun aBuildingThatCannotBeOpenedIsToldOnce() {
        val failed = NavigationState.Failed(NoStart.BUILDING_UNUSABLE, "building.cfg:3: no such room")
        assertEquals(listOf(Message.CannotStart(NoStart.BUILDING_UNUSABLE)), announcer.onState(failed))
        assertEquals(emptyList<Message>(), announcer.onState(failed))
    }
}
