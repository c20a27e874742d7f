package org.echoway.app.touch

import android.os.VibrationEffect
import android.os.Vibrator

/** The phone's vibrator; does nothing on a phone without one. */
class PhoneBuzzer(private val vibrator: Vibrator?) : Buzzer {
    override val present: Boolean get() = vibrator?.hasVibrator() == true

    override fun play(touch: Touch) {
        if (!present) return
        val pattern = touch.pattern
        val timings = pattern.timingsMs.toLongArray()
        val effect = if (vibrator?.hasAmplitudeControl() == true) {
            VibrationEffect.createWaveform(timings, pattern.strengths.toIntArray(), NO_REPEAT)
        } else {
            VibrationEffect.createWaveform(timings, NO_REPEAT)
        }
        vibrator?.vibrate(effect)
    }

    private companion object {
        const val NO_REPEAT = -1
    }
}
