package org.echoway.app.engine

import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.IOException
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.emptyFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
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
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** What the core is told of the belt that is worn, or was worn when a walk was recorded. */
@OptIn(ExperimentalCoroutinesApi::class)
@RunWith(AndroidJUnit4::class)
class NavigatorTest {
    private suspend fun TestScope.navigating(belt: (VirtualClock) -> BeltSource): Navigator {
        val clock = VirtualClock(testScheduler)
        val navigator = Navigator(StandardTestDispatcher(testScheduler), clock)
        val building = BundledBuildings(ApplicationProvider.getApplicationContext(), 1).find("torgersen-lab")!!
        backgroundScope.launch { navigator.run(building, Start(), belt(clock), MotionSource { emptyFlow() }) }
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

    @Test fun aRecordingThatCannotBeReadIsSaid() = runTest {
        val navigator = navigating { ReplayedBelt(it) { throw IOException("there is no such recording") } }
        advanceTimeBy(100)
        assertEquals(NavigationState.Failed("there is no such recording"), navigator.state.value)
    }

    @Test fun aBeltThatCannotBeIsSaid() = runTest {
        val navigator = navigating { ReplayedBelt(it) { log("# sensors 0\n") } }
        advanceTimeBy(100)
        assertEquals(NavigationState.Failed("line 1: # sensors 0: 0 is no sensible value for sensors"), navigator.state.value)
    }
}
