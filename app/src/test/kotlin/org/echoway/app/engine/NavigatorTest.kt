package org.echoway.app.engine

import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.IOException
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.flow.emptyFlow
import kotlinx.coroutines.flow.filterNot
import kotlinx.coroutines.flow.flowOf
import kotlinx.coroutines.flow.onCompletion
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource
import org.echoway.app.belt.ReplayedBelt
import org.echoway.app.belt.WalkLog
import org.echoway.app.belt.WireSentence
import org.echoway.app.building.BundledBuildings
import org.echoway.app.guide.hearsBelt
import org.echoway.app.motion.MotionSource
import org.echoway.app.testing.ScriptedBelt
import org.echoway.app.testing.VirtualClock
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Point
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import kotlin.math.PI

/** What the core is told of the belt that is worn, or was worn when a walk was recorded. */
@OptIn(ExperimentalCoroutinesApi::class)
@RunWith(AndroidJUnit4::class)
class NavigatorTest {
    private suspend fun TestScope.navigating(start: Start = Start(), belt: (VirtualClock) -> BeltSource): Navigator {
        val clock = VirtualClock(testScheduler)
        val navigator = Navigator(StandardTestDispatcher(testScheduler), clock)
        val building = BundledBuildings(ApplicationProvider.getApplicationContext(), 1).find("torgersen-lab")!!
        backgroundScope.launch { navigator.run(building, start, belt(clock), MotionSource { emptyFlow() }) }
        return navigator
    }

    private fun log(head: String) =
        WalkLog.read("${head}time_s,sensor,range_m\n0.0,0,1.5\n0.5,1,1.5\n1.0,2,1.5\n1.5,3,1.5\n".reader().buffered())

    @Test fun aRecordedWalkIsPlayedWithTheBeltThatItWasMadeWith() = runTest {
        val navigator = navigating { ReplayedBelt(it) { log("# sensors 4\n") } }
        backgroundScope.launch { navigator.picture.collect {} }
        advanceTimeBy(2_000)
        assertEquals(4, navigator.picture.value.scan.size)
    }

    @Test fun aBeltThatSaysItHasOtherSensorsIsTakenAtItsWord() = runTest {
        val belt = ScriptedBelt()
        val navigator = navigating { belt }
        backgroundScope.launch { navigator.picture.collect {} }
        advanceTimeBy(100)
        navigator.ask(Wish.LeadTo(Destination.WAY_OUT))
        belt.send(BeltEvent.Attached)
        belt.send(BeltEvent.Bytes(WireSentence.range(0, 0, 1.5), 0.1))
        belt.send(BeltEvent.Bytes(WireSentence.status(12, "test"), 0.15))
        advanceTimeBy(1_000)
        belt.send(BeltEvent.Bytes(WireSentence.range(1, 1, 1.5), 1.1))
        advanceTimeBy(1_000)
        val state = navigator.state.value as NavigationState.Running
        assertEquals(12, navigator.picture.value.scan.size)
        assertTrue("the way goes on", state.leading is Wish.LeadTo)
        assertTrue(state.hearsBelt)
    }

    /** Whoever tidies up the phone on their way still gets there. */
    @Test fun aBuildingThatIsDeletedWhileOneWalksInItIsWalkedOnInWithABeltOfOtherSensors() = runTest {
        val belt = ScriptedBelt()
        val navigator = navigating { belt }
        advanceTimeBy(100)
        (navigator.state.value as NavigationState.Running).building.folder.deleteRecursively()
        belt.send(BeltEvent.Attached)
        belt.send(BeltEvent.Bytes(WireSentence.status(12, "test"), 0.15))
        advanceTimeBy(1_000)
        assertEquals(12, (navigator.state.value as NavigationState.Running).belt.sensors.size)
    }

    @Test fun aRecordingThatCannotBeReadIsSaid() = runTest {
        val navigator = navigating { ReplayedBelt(it) { throw IOException("there is no such recording") } }
        advanceTimeBy(100)
        assertEquals(
            NavigationState.Failed(NoStart.RECORDING_UNREADABLE, "there is no such recording"), navigator.state.value,
        )
    }

    @Test fun aBeltThatCannotBeIsSaid() = runTest {
        val navigator = navigating { ReplayedBelt(it) { log("# sensors 0\n") } }
        advanceTimeBy(100)
        val reason = "line 1: # sensors 0: 0 is no sensible value for sensors"
        assertEquals(NavigationState.Failed(NoStart.RECORDING_UNREADABLE, reason), navigator.state.value)
    }

    private fun TestScope.eventsOf(navigator: Navigator) = mutableListOf<GuidanceEvent>().also { events ->
        backgroundScope.launch { navigator.events.filterNot { it is GuidanceEvent.Told }.toList(events) }
        runCurrent()
    }

    /** A belt that is heard for as long, each sensor in turn two metres from something. */
    private fun TestScope.echoes(belt: ScriptedBelt, seconds: Int) = repeat(seconds * 16) { i ->
        belt.send(BeltEvent.Bytes(WireSentence.range(i, i % 12, 2.0), testScheduler.currentTime / 1000.0))
        advanceTimeBy(62)
    }

    /** A belt that is heard for as long in the middle of a corridor: walls to both sides, and nothing else. */
    private fun TestScope.corridor(belt: ScriptedBelt, seconds: Int) = repeat(seconds * 16) { i ->
        val sensor = i % 15
        val range = if (sensor == 4 || sensor == 11) 0.6 else null
        belt.send(BeltEvent.Bytes(WireSentence.range(i, sensor, range), testScheduler.currentTime / 1000.0))
        advanceTimeBy(62)
    }

    private data class WayBack(val belt: ScriptedBelt, val navigator: Navigator, val events: List<GuidanceEvent>)

    /** Somebody who knew where they stood, was followed for ten seconds and is led back. */
    private suspend fun TestScope.wayBack(): WayBack {
        val belt = ScriptedBelt()
        val navigator = navigating(Start(room = 1, at = Point(0.75, 5.5), heading = PI / 2)) { belt }
        val events = eventsOf(navigator)
        belt.send(BeltEvent.Attached)
        corridor(belt, 10)
        navigator.ask(Wish.BackTrack)
        runCurrent()
        return WayBack(belt, navigator, events)
    }

    @Test fun aBeltThatChangesLongAfterTheStartLosesThePlaceAndTheWayBackAndThatIsSaid() = runTest {
        val (belt, navigator, events) = wayBack()
        assertEquals(GuidanceEvent.Granted(Wish.BackTrack), events.single())
        belt.send(BeltEvent.Bytes(WireSentence.status(12, "test"), testScheduler.currentTime / 1000.0))
        echoes(belt, 1)
        assertEquals(listOf(GuidanceEvent.BeltChanged(12), GuidanceEvent.WayBackLost), events.drop(1))
        assertEquals(null, (navigator.state.value as NavigationState.Running).leading)
    }

    @Test fun aBeltThatIsPluggedInLateAndHasOtherSensorsStartsWhereTheWearerSaid() = runTest {
        val belt = ScriptedBelt()
        val navigator = navigating(Start(room = 1)) { belt }
        val events = eventsOf(navigator)
        advanceTimeBy(60_000)
        belt.send(BeltEvent.Attached)
        belt.send(BeltEvent.Bytes(WireSentence.status(12, "test"), testScheduler.currentTime / 1000.0))
        echoes(belt, 1)
        assertEquals(1, (navigator.state.value as NavigationState.Running).estimate.room)
        assertEquals(emptyList<GuidanceEvent>(), events)
    }

    @Test fun aStartWhereNobodyCanStandIsRefusedAndNothingElseIsTold() = runTest {
        val navigator = navigating { ScriptedBelt() }
        val events = eventsOf(navigator)
        val outside = Wish.StandAt(Start(room = 0, at = Point(500.0, 500.0)), Destination(DestinationKind.EXIT, 0))
        navigator.ask(outside)
        runCurrent()
        assertEquals(outside, (events.single() as GuidanceEvent.Refused).wish)
    }

    @Test fun whoStartsAgainOnTheirWayBackHearsThatItIsLost() = runTest {
        val (_, navigator, events) = wayBack()
        val start = Wish.StandAt(Start(room = 0))
        navigator.ask(start)
        runCurrent()
        assertEquals(
            listOf(GuidanceEvent.Granted(Wish.BackTrack), GuidanceEvent.WayBackLost, GuidanceEvent.Granted(start)),
            events,
        )
    }

    @Test fun whoWishesToBeAskedAgainWhetherTheBeltMayBeUsedIs() = runTest {
        var asked = 0
        val belt = object : BeltSource {
            override val bringsMotion = true
            override val events =
                flowOf(BeltEvent.PermissionMissing, BeltEvent.PermissionRefused).onCompletion { awaitCancellation() }

            override fun askAgain() {
                asked++
            }
        }
        val navigator = navigating { belt }
        advanceTimeBy(100)
        assertEquals(Line.REFUSED, (navigator.state.value as NavigationState.Running).line)
        navigator.ask(Wish.AllowBelt)
        advanceTimeBy(100)
        assertEquals(1, asked)
    }
}
