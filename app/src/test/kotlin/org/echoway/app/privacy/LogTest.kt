package org.echoway.app.privacy

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.emptyFlow
import kotlinx.coroutines.flow.flowOf
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runTest
import org.echoway.app.belt.ReplayedBelt
import org.echoway.app.belt.WalkLog
import org.echoway.app.building.BundledBuildings
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Navigator
import org.echoway.app.motion.MotionSource
import org.echoway.app.recording.RecordingSwitch
import org.echoway.app.recording.Recordings
import org.echoway.app.testing.VirtualClock
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith
import org.robolectric.shadows.ShadowLog

/** A walk is led, recorded and asked about, and the system's log, which others may read, does not tell of it. */
@RunWith(AndroidJUnit4::class)
@OptIn(ExperimentalCoroutinesApi::class)
class LogTest {
    @get:Rule val temporary = TemporaryFolder()

    private val context = ApplicationProvider.getApplicationContext<Context>()

    private fun asset(kind: String) = context.assets.open("walks/torgersen-lab.$kind.csv").bufferedReader()

    @Test fun aWalkLeavesNoTraceInTheSystemsLog() = runTest {
        ShadowLog.clear()
        val clock = VirtualClock(testScheduler)
        val building = BundledBuildings(context, 1).find("torgersen-lab")!!
        val navigator = Navigator(StandardTestDispatcher(testScheduler), clock)
        val recordings = Recordings(temporary.root)
        val witness = RecordingSwitch(recordings, building)
        backgroundScope.launch { witness.follow(flowOf(true)) }
        backgroundScope.launch {
            navigator.run(
                building,
                Start(room = 0),
                ReplayedBelt(clock) { WalkLog.read(asset("scans"), asset("motion")) },
                MotionSource { emptyFlow() },
                witness,
            )
        }
        advanceTimeBy(20_000)
        val estimate = (navigator.state.value as NavigationState.Running).estimate
        assertTrue("the walk was followed", estimate.room >= 0 && estimate.timeS > 0)
        val walk = recordings.all().single()
        assertTrue("and recorded", recordings.files(walk.name).size == 3)
        assertEquals(emptyList<String>(), ShadowLog.getLogs().map { "${it.tag}: ${it.msg}" })
    }
}
