package org.echoway.app.belt

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.test.currentTime
import kotlinx.coroutines.test.runTest
import org.echoway.app.testing.VirtualClock
import org.echoway.core.BeltSetup
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test

@OptIn(ExperimentalCoroutinesApi::class)
class ReplayedBeltTest {
    private val log = WalkLog(
        belt = BeltSetup(sensors = 2),
        firings = listOf(LoggedFiring(10.0, 0, 1.0), LoggedFiring(10.5, 1, null), LoggedFiring(11.2, 0, 2.0)),
        hints = listOf(MotionHint(10.3, MotionKind.STEP, 1.0)),
    )

    @Test fun playsAtThePaceOfTheRecording() = runTest {
        val events = ReplayedBelt(VirtualClock(testScheduler)) { log }.events.toList()
        assertEquals(BeltEvent.Attached, events.first())
        assertEquals(BeltEvent.Ended, events.last())
        assertEquals(1200L, currentTime)
        val sentences = events.filterIsInstance<BeltEvent.Bytes>().map { it.data.decodeToString().substringBefore(',') }
        assertEquals(listOf("\$EWS", "\$EWR", "\$EWR", "\$EWS", "\$EWR"), sentences)
    }

    @Test fun hintsComeInTheirPlaceOnTheSameClock() = runTest {
        val events = ReplayedBelt(VirtualClock(testScheduler)) { log }.events.toList()
        val hint = events.indexOfFirst { it is BeltEvent.Motion }
        assertEquals(0.3, (events[hint] as BeltEvent.Motion).hint.timeS, 1e-9)
        val arrivals = events.filterIsInstance<BeltEvent.Bytes>().map { it.arrivalS }
        assertTrue(arrivals.zipWithNext().all { (a, b) -> a <= b })
        assertEquals(0.5, (events[hint + 1] as BeltEvent.Bytes).arrivalS, 1e-9)
    }

    @Test fun theWearersWordOfWhereTheyStandComesInItsPlace() = runTest {
        val restart = LoggedRestart(10.2, "4", null, null)
        val events = ReplayedBelt(VirtualClock(testScheduler)) { log.copy(restarts = listOf(restart)) }.events.toList()
        val at = events.indexOf(BeltEvent.Restart(restart))
        assertTrue(events[at - 1] is BeltEvent.Bytes)
        assertTrue("before the step that follows it", events[at + 1] is BeltEvent.Motion)
    }
}
