package org.echoway.app.control

import android.content.Context
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

    private val headset: MediaController by lazy {
        val connecting = MediaController.Builder(context, controls.session.token).buildAsync()
        settle()
        connecting.get(1, TimeUnit.SECONDS)
    }

    @After fun close() {
        headset.release()
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
}
