package org.echoway.app.touch

import android.content.Context
import android.os.VibrationEffect.Composition
import android.os.Vibrator
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf

@RunWith(AndroidJUnit4::class)
class PhoneBuzzerTest {
    private val vibrator = ApplicationProvider.getApplicationContext<Context>().getSystemService(Vibrator::class.java)
    private val shadow get() = shadowOf(vibrator)

    /** Pauses and pulses in milliseconds of every word, beginning with a pause. */
    private val waveforms = mapOf(
        Touch.LEFT to longArrayOf(0, 350, 120, 90),
        Touch.RIGHT to longArrayOf(0, 90, 120, 350),
        Touch.AHEAD to longArrayOf(0, 90),
        Touch.TURN_AROUND to longArrayOf(0, 350, 120, 350),
        Touch.ARRIVED to longArrayOf(0, 90, 120, 90, 120, 90),
        Touch.SOMETHING_AHEAD to longArrayOf(0, 40),
        Touch.ROOM_ENTERED to longArrayOf(0, 90, 120, 90),
        Touch.UNSURE to longArrayOf(0, 1200),
        Touch.BELT_LOST to longArrayOf(0, 350, 120, 350, 120, 350),
        Touch.BELT_BACK to longArrayOf(0, 90, 120, 90, 120, 90),
        Touch.MOVE_NOW to longArrayOf(0, 1200),
    )

    @Test fun everyWordIsAWaveformWhereThereAreNoPrimitives() {
        shadow.setHasAmplitudeControl(true)
        assertEquals(Touch.entries.toSet(), waveforms.keys)
        waveforms.forEach { (touch, pattern) ->
            PhoneBuzzer(vibrator).play(touch)
            assertTrue(shadow.isVibrating)
            assertArrayEquals("$touch", pattern, shadow.pattern)
        }
    }

    @Test fun aMotorOfOneStrengthPlaysNoTwoWordsAlike() {
        val felt = Touch.entries.associateWith {
            PhoneBuzzer(vibrator).play(it)
            shadow.pattern.toList()
        }
        assertEquals("$felt", Touch.entries.size, felt.values.distinct().size)
        assertEquals(
            "growing stronger is growing longer", listOf(0L, 45L, 120L, 63L, 120L, 90L), felt.getValue(Touch.ARRIVED),
        )
    }

    @Test fun primitivesAreUsedWhereAllOfAWordAreSupported() {
        shadow.setSupportedPrimitives(
            listOf(Composition.PRIMITIVE_CLICK, Composition.PRIMITIVE_THUD, Composition.PRIMITIVE_TICK),
        )
        fun primitives(touch: Touch): List<Int> {
            PhoneBuzzer(vibrator).play(touch)
            return shadow.primitiveSegmentsInPrimitiveEffects.map { primitiveOf(it) }
        }
        assertEquals(listOf(Composition.PRIMITIVE_THUD, Composition.PRIMITIVE_CLICK), primitives(Touch.LEFT))
        assertEquals(listOf(Composition.PRIMITIVE_CLICK, Composition.PRIMITIVE_THUD), primitives(Touch.RIGHT))
        assertEquals(listOf(Composition.PRIMITIVE_TICK), primitives(Touch.SOMETHING_AHEAD))
    }

    /** The shadow's own record of a primitive tells its fields only in words. */
    private fun primitiveOf(segment: Any): Int = Regex("id=(\\d+)").find("$segment")!!.groupValues[1].toInt()

    @Test fun aMotorThatLacksOnePrimitivePlaysTheWaveform() {
        shadow.setHasAmplitudeControl(true)
        shadow.setSupportedPrimitives(listOf(Composition.PRIMITIVE_CLICK))
        PhoneBuzzer(vibrator).play(Touch.LEFT)
        assertArrayEquals(waveforms.getValue(Touch.LEFT), shadow.pattern)
        PhoneBuzzer(vibrator).play(Touch.UNSURE)
        assertArrayEquals("no primitive is that long", waveforms.getValue(Touch.UNSURE), shadow.pattern)
    }

    @Test fun aPhoneWithoutAVibratorIsFine() {
        shadow.setHasVibrator(false)
        val buzzer = PhoneBuzzer(vibrator)
        assertFalse(buzzer.present)
        buzzer.play(Touch.AHEAD)
        assertFalse(shadow.isVibrating)
        assertFalse(PhoneBuzzer(null).present)
    }

    @Test fun wordsCanBeToldApart() {
        assertEquals(Touch.entries.size, Touch.entries.map { it.pulses }.distinct().size)
        assertTrue("two pulses are felt as two", GAP_MS >= 50)
        Strength.entries.map { it.amplitude }.zipWithNext().forEach { (soft, strong) ->
            assertTrue("$soft, $strong", strong >= 1.4 * soft)
        }
        assertEquals(Strength.entries, Touch.ARRIVED.pulses.map { it.strength })
    }

    @Test fun ticksQuickenAsItNearsButStayApart() {
        val gaps = (0..40).map { tickGapMs(it / 10.0) }
        assertEquals(gaps.sorted(), gaps)
        assertTrue("${gaps.first()}", gaps.first() - Length.TICK.ms >= 50)
        assertTrue("${gaps.last()}", gaps.last() > 4 * gaps.first())
    }
}
