package org.echoway.app.ui.setup

import android.app.Application
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.InputStream
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import org.echoway.app.service.TestContainer
import org.echoway.app.settings.SourceKind
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.shadows.ShadowLooper

/** A recorded walk that the wearer picks is somebody else's file. */
@RunWith(AndroidJUnit4::class)
class SetupViewModelTest {
    private val container = TestContainer(ApplicationProvider.getApplicationContext<Application>())
    private val model = SetupViewModel(container)
    private val scope = MainScope().also { it.launch { model.uiState.collect {} } }

    @After fun close() = scope.cancel()

    private fun await(what: String, condition: () -> Boolean) {
        repeat(1_000) {
            if (condition()) return
            ShadowLooper.idleMainLooper()
            Thread.sleep(10)
        }
        throw AssertionError("never came: $what")
    }

    private val problem get() = (model.uiState.value as? SetupUiState.Ready)?.recordingProblem

    @Test fun aGoodOneIsKeptAndChosen() {
        model.useRecording("mine.csv") { "time_s,sensor,range_m\n0.0,0,1.5\n".byteInputStream() }
        await("the recording") { container.settings.settings.value.recording != null }
        assertEquals("mine.scans.csv", container.settings.settings.value.recording)
        assertEquals(SourceKind.RECORDING, container.settings.settings.value.source)
        assertNull(problem)
    }

    @Test fun aFileWithoutAnEndIsRefusedAndDoesNotFillThePhone() {
        model.useRecording("endless.csv") {
            object : InputStream() {
                override fun read() = '#'.code

                override fun read(into: ByteArray, offset: Int, length: Int): Int =
                    length.also { into.fill('#'.code.toByte(), offset, offset + length) }
            }
        }
        await("a refusal") { problem != null }
        assertTrue("$problem", "larger than any recorded walk" in problem!!)
        assertEquals(emptyList<String>(), container.cacheDir.list().orEmpty().toList())
        assertNull(container.settings.settings.value.recording)
    }
}
