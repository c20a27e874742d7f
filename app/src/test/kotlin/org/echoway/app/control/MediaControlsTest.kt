package org.echoway.app.control

import android.content.Context
import android.view.KeyEvent
import androidx.media3.common.C
import androidx.media3.session.MediaController
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.concurrent.TimeUnit
import org.echoway.app.Clock
import org.echoway.app.guide.Ask
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.shadows.ShadowLooper

/** What a headset's or a car's buttons do, through the session that Android hands them to. */
@RunWith(AndroidJUnit4::class)
class MediaControlsTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val asked = mutableListOf<Ask>()
    private var claims = 0
    private val controls = MediaControls(context, { asked += it }, Clock.SYSTEM, { claims++ })

    private fun settle() = repeat(20) { ShadowLooper.idleMainLooper(20, TimeUnit.MILLISECONDS) }

    private val connection = lazy {
        val connecting = MediaController.Builder(context, controls.session.token).buildAsync()
        settle()
        connecting.get(1, TimeUnit.SECONDS)
    }
    private val headset: MediaController by connection

    @After fun close() {
        if (connection.isInitialized()) headset.release()
        controls.close()
    }

    @Test fun everyButtonAsks() {
        assertEquals("Android must know whom to ask", 1, claims)
        headset.pause()
        headset.seekToNext()
        headset.seekToPrevious()
        headset.stop()
        settle()
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.REPEAT, Ask.WAY_OUT, Ask.MUTE), asked)
    }

    @Test fun itGoesOnPlayingSoThatTheNextPressAsksAgain() {
        headset.pause()
        settle()
        assertTrue(headset.playWhenReady)
        headset.pause()
        settle()
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.WHERE_AM_I), asked)
    }

    private fun pressed(vararg keys: Int, betweenMs: Long = 200): List<Ask> {
        asked.clear()
        for (key in keys) {
            controls.session.press(key)
            ShadowLooper.idleMainLooper(betweenMs, TimeUnit.MILLISECONDS)
        }
        ShadowLooper.idleMainLooper(2, TimeUnit.SECONDS)
        return asked.toList()
    }

    @Test fun everyMediaKeyAsks() {
        assertEquals(listOf(Ask.WHERE_AM_I), pressed(KeyEvent.KEYCODE_MEDIA_PLAY))
        assertEquals(listOf(Ask.WHERE_AM_I), pressed(KeyEvent.KEYCODE_MEDIA_PAUSE))
        assertEquals(listOf(Ask.REPEAT), pressed(KeyEvent.KEYCODE_MEDIA_NEXT))
        assertEquals(listOf(Ask.WAY_OUT), pressed(KeyEvent.KEYCODE_MEDIA_PREVIOUS))
        assertEquals(listOf(Ask.MUTE), pressed(KeyEvent.KEYCODE_MEDIA_STOP))
        assertEquals(emptyList<Ask>(), pressed(KeyEvent.KEYCODE_MEDIA_RECORD))
    }

    @Test fun aHeadsetWithOneButtonAsksByTheNumberOfPresses() {
        for (button in listOf(KeyEvent.KEYCODE_HEADSETHOOK, KeyEvent.KEYCODE_MEDIA_PLAY_PAUSE)) {
            assertEquals(listOf(Ask.WHERE_AM_I), pressed(button))
            assertEquals(listOf(Ask.REPEAT), pressed(button, button))
            assertEquals(listOf(Ask.WAY_OUT), pressed(button, button, button))
            assertEquals(listOf(Ask.START_AGAIN), pressed(button, button, button, button))
            assertEquals(
                "slow presses are one each",
                listOf(Ask.WHERE_AM_I, Ask.WHERE_AM_I),
                pressed(button, button, betweenMs = 1_000),
            )
        }
    }

    @Test fun aPressThatIsStillCountedWhenGuidanceEndsAsksNothing() {
        controls.session.press(KeyEvent.KEYCODE_HEADSETHOOK)
        controls.close()
        ShadowLooper.idleMainLooper(2, TimeUnit.SECONDS)
        assertEquals(emptyList<Ask>(), asked)
    }

    @Test fun volumeKeysAskWithTheScreenOffInFirefighterMode() {
        controls.takesVolumeKeys = true
        settle()
        headset.increaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        settle()
        ShadowLooper.idleMainLooper(3, TimeUnit.SECONDS)
        headset.decreaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        headset.decreaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        settle()
        assertEquals("a key that is held asks once", listOf(Ask.WHERE_AM_I, Ask.WAY_BACK), asked)
    }

    @Test fun anotherVolumeKeySoonAfterTheFirstAsksToo() {
        controls.takesVolumeKeys = true
        settle()
        headset.increaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        settle()
        headset.decreaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        settle()
        headset.increaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        settle()
        assertEquals(listOf(Ask.WHERE_AM_I, Ask.WAY_BACK, Ask.WHERE_AM_I), asked)
    }

    @Test fun bothVolumeKeysTogetherAreOneQuestionHoweverLongTheyAreHeld() {
        controls.takesVolumeKeys = true
        settle()
        headset.decreaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
        ShadowLooper.idleMainLooper(100, TimeUnit.MILLISECONDS)
        repeat(30) {
            headset.increaseDeviceVolume(C.VOLUME_FLAG_SHOW_UI)
            ShadowLooper.idleMainLooper(50, TimeUnit.MILLISECONDS)
        }
        settle()
        assertEquals("what the first of them asks", listOf(Ask.WAY_BACK), asked)
    }
}
