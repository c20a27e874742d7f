package org.echoway.app.recording

import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import java.nio.file.Files
import java.time.LocalDateTime
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import org.echoway.app.belt.WalkLog
import org.echoway.app.testing.SamplePlan
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.echoway.core.Point
import org.echoway.core.SensorHealth
import org.echoway.core.SensorState
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class RecordingsTest {
    @get:Rule val temporary = TemporaryFolder()

    private var now = LocalDateTime.of(2026, 11, 25, 20, 15, 3)
    private val recordings by lazy { Recordings(temporary.root) { now } }

    private fun sensor(timeS: Double, rangeM: Double?) = SensorHealth(SensorState.GOOD, 1, 1, 0, rangeM, timeS)

    private fun file(kind: String) = File(temporary.root, "2026-11-25_20-15-03$kind")

    private fun walk(recorder: Recorder) {
        recorder.onFirings(listOf(sensor(100.0, 1.5), sensor(-1.0, null), sensor(-1.0, null)))
        recorder.onMotion(MotionHint(100.03, MotionKind.STEP, 1.0))
        recorder.onFirings(listOf(sensor(100.0, 1.5), sensor(100.0624, null), sensor(-1.0, null)))
        recorder.onEstimate(SamplePlan.estimate(1, 2.0, 3.0, headingDegrees = 90.0).copy(timeS = 100.0624))
        recorder.onMotion(MotionHint(100.07, MotionKind.YAW_RATE, Math.PI / 2))
    }

    @Test fun aWalkBecomesTheLogsOfTheContract() {
        val recorder = recordings.start(SamplePlan.building)!!
        walk(recorder)
        recordings.stop(recorder)
        assertEquals(
            "# building sample\n# sensors 3\ntime_s,sensor,range_m\n0.0000,0,1.5000\n0.0624,1,\n",
            file(".scans.csv").readText(),
        )
        assertEquals(
            "time_s,kind,value\n0.0300,step,1.0000\n0.0700,yaw_rate_dps,90.0000\n", file(".motion.csv").readText(),
        )
        assertEquals(
            "time_s,room,x_m,y_m,heading_deg,sigma_m,room_probability,state\n" +
                "0.0624,4,2.0000,3.0000,90.0000,0.1000,0.9500,tracking\n",
            file(".track.csv").readText(),
        )
    }

    @Test fun aBeltMaySayHowManySensorsItHasAfterSomeHaveFired() {
        val recorder = recordings.start(SamplePlan.building)!!
        walk(recorder)
        recorder.onFirings(List(4) { if (it == 3) sensor(100.2, 2.0) else sensor(-1.0, null) })
        recordings.stop(recorder)
        assertEquals(
            "# building sample\n# sensors 4\ntime_s,sensor,range_m\n0.0000,0,1.5000\n0.0624,1,\n0.2000,3,2.0000\n",
            file(".scans.csv").readText(),
        )
    }

    @Test fun whatWasRecordedCanBeReadBackAndReplayed() {
        val recorder = recordings.start(SamplePlan.building)!!
        walk(recorder)
        recordings.stop(recorder)
        val log = WalkLog.read(file(".scans.csv").bufferedReader(), file(".motion.csv").bufferedReader())
        assertEquals(listOf(1.5, null), log.firings.map { it.rangeM })
        assertEquals(listOf(MotionKind.STEP, MotionKind.YAW_RATE), log.hints.map { it.kind })
    }

    @Test fun aStepThatThePhoneTellsOfLateCountsFromWhenItCame() {
        val recorder = recordings.start(SamplePlan.building)!!
        recorder.onMotion(MotionHint(100.0, MotionKind.YAW_RATE, 0.0))
        recorder.onMotion(MotionHint(101.5, MotionKind.YAW_RATE, 0.0))
        recorder.onMotion(MotionHint(100.4, MotionKind.STEP, 1.0))
        recordings.stop(recorder)
        assertEquals(
            "time_s,kind,value\n0.0000,yaw_rate_dps,0.0000\n1.5000,yaw_rate_dps,0.0000\n1.5000,step,1.0000\n",
            file(".motion.csv").readText(),
        )
    }

    @Test fun whereTheWearerSaidThatTheyStandIsReadBackInItsPlace() {
        val recorder = recordings.start(SamplePlan.building)!!
        recorder.onRestart(Start(), 99.9)
        walk(recorder)
        recorder.onRestart(Start(1, Point(2.0, 3.0), Math.PI / 2), 100.0624)
        recorder.onFirings(listOf(sensor(100.1248, 1.4), sensor(100.0624, null), sensor(-1.0, null)))
        recordings.stop(recorder)
        val log = WalkLog.read(file(".scans.csv").bufferedReader())
        assertEquals(3, log.firings.size)
        assertEquals(listOf(0.0, 0.1624), log.restarts.map { it.timeS })
        assertEquals(
            listOf(Start(), Start(1, Point(2.0, 3.0), Math.toRadians(90.0))),
            log.restarts.map { it.startIn(SamplePlan.plan) },
        )
    }

    @Test fun afterACrashTheWalkIsThereButForTheLastSecond() {
        val recorder = recordings.start(SamplePlan.building)!!
        repeat(160) { recorder.onFirings(listOf(sensor(it / 16.0, 1.0))) }
        // Nobody closes the files: the process is gone.
        val log = WalkLog.read(file(".scans.csv").bufferedReader())
        assertTrue("${log.firings.last()}", log.firings.last().timeS > 8.5)
    }

    @Test fun aTornLastLineIsForgiven() {
        val text = "time_s,sensor,range_m\n0.0,0,1.5\n0.06,1,2"
        assertEquals(1, WalkLog.read(text.reader().buffered()).firings.size)
        file(".scans.csv").writeText("# building sample\n$text")
        runTest { assertEquals(0.0, recordings.all().single().durationS!!, 0.0) }
    }

    @Test fun aFullDiskIsToldAndTheWalkGoesOn() {
        // Every write to this device fails for want of room.
        Files.createSymbolicLink(file(".scans.csv").toPath(), File("/dev/full").toPath())
        val recorder = recordings.start(SamplePlan.building)!!
        repeat(3) { recorder.onFirings(listOf(sensor(it.toDouble(), 1.0))) }
        assertEquals(true, (recordings.status.value as RecordingStatus.Failed).diskFull)
        recordings.stop(recorder)
        assertTrue("the failure stays told", recordings.status.value is RecordingStatus.Failed)
    }

    @Test fun recordingsAreListedNewestFirstAndDeletedWithAllTheirFiles() = runTest {
        for (minute in listOf(10, 20)) {
            now = now.withMinute(minute)
            recordings.start(SamplePlan.building)!!.let {
                walk(it)
                recordings.stop(it)
            }
        }
        File(temporary.root, "brought.scans.csv").writeText("time_s,sensor,range_m\n0.0,0,1.5\n7.5,0,1.5\n")
        val all = recordings.all()
        assertEquals(listOf("2026-11-25_20-20-03", "2026-11-25_20-10-03", "brought"), all.map { it.name })
        assertEquals("sample", all[0].building)
        assertNull(all[2].building)
        assertEquals(7.5, all[2].durationS!!, 0.0)
        assertEquals(3, recordings.files(all[0].name).size)
        recordings.delete(all[0].name)
        assertEquals(listOf("2026-11-25_20-10-03", "brought"), recordings.all().map { it.name })
        assertTrue(temporary.root.list()!!.none { "20-20-03" in it })
    }

    @Test fun aNameLeadsNowhereElse() = runTest {
        val other = temporary.newFile("other.scans.csv")
        val inner = Recordings(temporary.newFolder("inner"))
        inner.delete("../other")
        assertTrue(other.exists())
    }

    @OptIn(ExperimentalCoroutinesApi::class)
    @Test fun theSwitchHoldsAtOnce() = runTest {
        val wished = MutableStateFlow(false)
        val switch = RecordingSwitch(recordings, SamplePlan.building)
        backgroundScope.launch { switch.follow(wished) }
        runCurrent()
        switch.onFirings(listOf(sensor(1.0, 1.0)))
        assertEquals(RecordingStatus.Off, recordings.status.value)
        wished.value = true
        runCurrent()
        assertEquals(RecordingStatus.On("2026-11-25_20-15-03"), recordings.status.value)
        switch.onFirings(listOf(sensor(2.0, 1.0)))
        wished.value = false
        runCurrent()
        assertEquals(RecordingStatus.Off, recordings.status.value)
        assertEquals("0.0000,0,1.0000", file(".scans.csv").readLines().last())
    }
}
