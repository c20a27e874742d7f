package org.echoway.app.touch

import android.media.AudioAttributes
import android.os.Build
import android.os.VibrationAttributes
import android.os.VibrationEffect
import android.os.VibrationEffect.Composition
import android.os.Vibrator
import androidx.annotation.RequiresApi

/**
 * The phone's vibrator: crisp primitives where it has them, waveforms elsewhere; does nothing on a phone without one.
 * As accessibility feedback, so that it is felt with the screen off and the ringer silent.
 */
class PhoneBuzzer(private val vibrator: Vibrator?) : Buzzer {
    override val present: Boolean get() = vibrator?.hasVibrator() == true

    override fun play(touch: Touch) {
        val motor = vibrator?.takeIf { it.hasVibrator() } ?: return
        val effect = composition(motor, touch.pulses) ?: waveform(motor, touch.pulses)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.TIRAMISU) {
            motor.vibrate(effect, VibrationAttributes.createForUsage(VibrationAttributes.USAGE_ACCESSIBILITY))
        } else {
            @Suppress("DEPRECATION")
            motor.vibrate(effect, ACCESSIBILITY)
        }
    }

    /** Null where the motor lacks one of the primitives, or none is as long as a pulse. */
    private fun composition(motor: Vibrator, pulses: List<Pulse>): VibrationEffect? {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.R) return null
        val primitives = pulses.map { primitive(it.length) ?: return null }
        if (!motor.areAllPrimitivesSupported(*primitives.toIntArray())) return null
        val composition = VibrationEffect.startComposition()
        pulses.forEachIndexed { index, pulse ->
            composition.addPrimitive(primitives[index], pulse.strength.scale, if (index == 0) 0 else GAP_MS.toInt())
        }
        return composition.compose()
    }

    @RequiresApi(Build.VERSION_CODES.R)
    private fun primitive(length: Length): Int? = when (length) {
        Length.TICK -> Composition.PRIMITIVE_TICK
        Length.SHORT -> Composition.PRIMITIVE_CLICK
        Length.LONG -> if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) Composition.PRIMITIVE_THUD else null
        Length.VERY_LONG -> null
    }

    private fun waveform(motor: Vibrator, pulses: List<Pulse>): VibrationEffect {
        fun timings(length: (Pulse) -> Long) =
            pulses.flatMapIndexed { index, pulse -> listOf(if (index == 0) 0L else GAP_MS, length(pulse)) }
                .toLongArray()

        // A motor that knows one strength only: what is softer is shorter, so that no two words feel alike.
        if (!motor.hasAmplitudeControl()) {
            return VibrationEffect.createWaveform(timings { it.lengthAtOneStrengthMs }, NO_REPEAT)
        }
        val timings = timings { it.length.ms }
        val amplitudes = pulses.flatMap { listOf(0, it.strength.amplitude) }.toIntArray()
        return VibrationEffect.createWaveform(timings, amplitudes, NO_REPEAT)
    }

    private val Strength.scale get() = amplitude / Strength.STRONG.amplitude.toFloat()

    private companion object {
        const val NO_REPEAT = -1
        val ACCESSIBILITY: AudioAttributes =
            AudioAttributes.Builder().setUsage(AudioAttributes.USAGE_ASSISTANCE_ACCESSIBILITY).build()
    }
}
