package org.echoway.app.control

import android.media.AudioManager
import android.media.ToneGenerator

/**
 * Tones on the alarm's own volume, which a silent phone keeps. Quiet where Android has no tone generator left to give.
 */
class PhoneSiren : Siren {
    private val tones by lazy {
        runCatching { ToneGenerator(AudioManager.STREAM_ALARM, ToneGenerator.MAX_VOLUME) }.getOrNull()
    }

    override fun warn() {
        tones?.startTone(ToneGenerator.TONE_CDMA_ALERT_CALL_GUARD, WARNING_MS)
    }

    override fun sound(on: Boolean) {
        if (on) tones?.startTone(ToneGenerator.TONE_CDMA_EMERGENCY_RINGBACK) else tones?.stopTone()
    }

    private companion object {
        const val WARNING_MS = 1000
    }
}
