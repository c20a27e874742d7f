package org.echoway.app.touch

import android.content.Context
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

    @Test fun playsThePatternOfTheWord() {
        PhoneBuzzer(vibrator).play(Touch.BELT_LOST)
        assertTrue(shadowOf(vibrator).isVibrating)
        assertArrayEquals(longArrayOf(0, 350, 120, 350, 120, 350), shadowOf(vibrator).pattern)
    }

    @Test fun aPhoneWithoutAVibratorIsFine() {
        shadowOf(vibrator).setHasVibrator(false)
        val buzzer = PhoneBuzzer(vibrator)
        assertFalse(buzzer.present)
        buzzer.play(Touch.AHEAD)
        assertFalse(shadowOf(vibrator).isVibrating)
        assertFalse(PhoneBuzzer(null).present)
    }

    @Test fun wordsCanBeToldApart() {
        assertEquals(Touch.entries.size, Touch.entries.map { it.pattern }.distinct().size)
        for (touch in Touch.entries) {
            val (timings, strengths) = touch.pattern
            assertEquals(timings.size, strengths.size)
            timings.filterIndexed { i, _ -> i % 2 == 0 && i > 0 }.forEach { assertTrue("$touch pauses $it ms", it >= 50) }
        }
        val strengths = Touch.entries.flatMap { it.pattern.strengths }.filter { it > 0 }.distinct().sorted()
        strengths.zipWithNext().forEach { (soft, strong) -> assertTrue("$soft and $strong", strong >= 1.4 * soft) }
    }
}
