package org.echoway.app.motion

import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Test

class YawRateTest {
    @Test fun isAboutTheVerticalHoweverThePhoneSits() {
        val flat = YawRate().apply { gravity(floatArrayOf(0f, 0f, 9.81f)) }
        assertEquals(0.5, flat.rate(floatArrayOf(0f, 0f, 0.5f), 0.0)!!, 1e-6)
        // Upright in a chest pocket: its y axis points up, and rocking about x or z is no turn.
        val upright = YawRate().apply { gravity(floatArrayOf(0f, 9.81f, 0f)) }
        assertEquals(0.5, upright.rate(floatArrayOf(3f, 0.5f, -3f), 0.0)!!, 1e-6)
        val upsideDown = YawRate().apply { gravity(floatArrayOf(0f, -9.81f, 0f)) }
        assertEquals(-0.5, upsideDown.rate(floatArrayOf(0f, 0.5f, 0f), 0.0)!!, 1e-6)
    }

    @Test fun saysNothingBeforeItKnowsWhichWayIsUp() {
        assertNull(YawRate().rate(floatArrayOf(0f, 0f, 1f), 0.0))
        assertNull(YawRate().apply { gravity(floatArrayOf(0f, 0f, 0f)) }.rate(floatArrayOf(0f, 0f, 1f), 0.0))
    }

    @Test fun averagesWhatComesBetween() {
        val yaw = YawRate().apply { gravity(floatArrayOf(0f, 0f, 9.81f)) }
        yaw.rate(floatArrayOf(0f, 0f, 0f), 0.0)
        assertNull(yaw.rate(floatArrayOf(0f, 0f, 1f), 0.02))
        assertEquals(2.0, yaw.rate(floatArrayOf(0f, 0f, 3f), 0.06)!!, 1e-6)
    }
}
