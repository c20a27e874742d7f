package org.echoway.app.guide

import org.junit.Assert.assertEquals
import org.junit.Test

class DirectionTest {
    @Test fun sectorsAreThoseOfTheVoice() {
        val expected = mapOf(
            0.0 to Direction.AHEAD, 19.0 to Direction.AHEAD, -19.0 to Direction.AHEAD,
            21.0 to Direction.SLIGHTLY_LEFT, -44.0 to Direction.SLIGHTLY_RIGHT,
            46.0 to Direction.LEFT, -119.0 to Direction.RIGHT,
            121.0 to Direction.SHARP_LEFT, -159.0 to Direction.SHARP_RIGHT,
            161.0 to Direction.BEHIND, -179.0 to Direction.BEHIND, 540.0 to Direction.BEHIND, 361.0 to Direction.AHEAD,
        )
        expected.forEach { (degrees, direction) -> assertEquals("$degrees", direction, Direction.of(Math.toRadians(degrees))) }
    }

    @Test fun sidesOfTheBeltGoCounterClockwiseFromTheFront() {
        assertEquals(listOf(Side.FRONT, Side.FRONT_LEFT, Side.FRONT_LEFT, Side.LEFT), (0..3).map { Side.of(it, 15) })
        assertEquals(Side.BACK, Side.of(7, 15))
        assertEquals(Side.RIGHT, Side.of(11, 15))
        assertEquals(Side.FRONT, Side.of(0, 1))
    }
}
