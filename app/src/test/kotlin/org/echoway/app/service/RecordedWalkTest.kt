package org.echoway.app.service

import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import java.nio.file.Files
import java.util.concurrent.TimeUnit
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.WalkLog
import org.echoway.app.belt.WireSentence
import org.echoway.app.engine.NavigationState
import org.echoway.app.recording.RecordingStatus
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowLooper

/** Guidance that is told to record leaves the belt's echoes in a log that can be played again. */
@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class)
class RecordedWalkTest {
    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val container get() = app.container

    private fun settle(millis: Long) = repeat(10) {
        ShadowLooper.idleMainLooper(millis / 10, TimeUnit.MILLISECONDS)
        Thread.sleep(2)
    }

    @Test fun everyFiringThatTheBeltSentIsInTheLog() {
        container.settings.settings.value = container.settings.settings.value.copy(record = true)
        val service = Robolectric.buildService(NavigationService::class.java).create()
        service.get().onStartCommand(NavigationService.intent(app, NavigationService.ACTION_START), 0, 1)
        repeat(500) { if (container.navigator.state.value !is NavigationState.Running) settle(20) }
        container.belt.send(BeltEvent.Attached)
        repeat(FIRINGS) { sequence ->
            val range = if (sequence % 4 == 3) null else 1.0 + sequence / 100.0
            container.belt.send(
                BeltEvent.Bytes(WireSentence.range(sequence, sequence % 15, range), container.clock.nowS()),
            )
            ShadowLooper.idleMainLooper(62, TimeUnit.MILLISECONDS)
        }
        service.get().onStartCommand(NavigationService.intent(app, NavigationService.ACTION_STOP), 0, 2)
        settle(1_000)
        service.destroy()

        val scans = container.recordings.folder.listFiles()!!.single { it.name.endsWith(".scans.csv") }
        val log = WalkLog.read(scans.bufferedReader())
        assertEquals(List(FIRINGS) { it % 15 }, log.firings.map { it.sensor })
        // In whole millimetres, as the belt says them.
        assertEquals(
            List(FIRINGS) { if (it % 4 == 3) null else 1000 + 10 * it },
            log.firings.map { it.rangeM?.let { m -> Math.round(m * 1000).toInt() } },
        )
        assertTrue(log.firings.zipWithNext().all { (a, b) -> b.timeS - a.timeS in 0.05..0.08 })
        assertEquals("torgersen-lab", scans.readLines().first().removePrefix("# building "))
    }

    @Test fun aFullPhoneIsToldAndGuidanceGoesOn() {
        container.settings.settings.value = container.settings.settings.value.copy(record = true)
        val service = Robolectric.buildService(NavigationService::class.java).create()
        service.get().onStartCommand(NavigationService.intent(app, NavigationService.ACTION_START), 0, 1)
        repeat(500) { if (container.recordings.status.value !is RecordingStatus.On) settle(20) }
        // Every write to this device fails for want of room.
        val name = (container.recordings.status.value as RecordingStatus.On).name
        Files.createSymbolicLink(
            File(container.recordings.folder, "$name.scans.csv").toPath(), File("/dev/full").toPath(),
        )
        container.belt.send(BeltEvent.Attached)
        repeat(FIRINGS) { sequence ->
            container.belt.send(
                BeltEvent.Bytes(WireSentence.range(sequence, sequence % 15, 2.0), container.clock.nowS()),
            )
            ShadowLooper.idleMainLooper(62, TimeUnit.MILLISECONDS)
        }
        settle(5_000)
        assertTrue("${container.voice.words}", "Recording stopped. The phone is full." in container.voice.words)
        assertTrue(container.navigator.state.value is NavigationState.Running)
        service.destroy()
    }

    private companion object {
        const val FIRINGS = 60
    }
}
