package org.echoway.app.guide

import org.junit.Assert.assertEquals
import org.junit.Test

class SideTest {
    @Test fun sidesOfTheBeltGoCounterClockwiseFromTheFront() {
        assertEquals(listOf(Side.FRONT, Side.FRONT_LEFT, Side.FRONT_LEFT, Side.LEFT), (0..3).map { Side.of(it, 15) })
        assertEquals(Side.BACK, Side.of(7, 15))
        assertEquals(Side.RIGHT, Side.of(11, 15))
        assertEquals(Side.FRONT, Side.of(0, 1))
    }
}
