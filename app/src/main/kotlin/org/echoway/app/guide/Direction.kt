package org.echoway.app.guide

import kotlin.math.PI
import kotlin.math.IEEErem
import kotlin.math.abs
import kotlin.math.atan2
import org.echoway.core.Point

/** Directions from the chest, as they are spoken. */
enum class Direction {
    AHEAD,
    SLIGHTLY_LEFT,
    SLIGHTLY_RIGHT,
    LEFT,
    RIGHT,
    SHARP_LEFT,
    SHARP_RIGHT,
    BEHIND,
    ;

    companion object {
        private const val AHEAD_DEG = 20.0
        private const val SLIGHT_DEG = 45.0
        private const val SIDE_DEG = 120.0
        private const val SHARP_DEG = 160.0

        /** [bearing] from the chest, radians, counter-clockwise (left is positive). */
        fun of(bearing: Double): Direction {
            val degrees = Math.toDegrees(bearing.IEEErem(2 * PI))
            val left = degrees > 0
            return when {
                abs(degrees) <= AHEAD_DEG -> AHEAD
                abs(degrees) <= SLIGHT_DEG -> if (left) SLIGHTLY_LEFT else SLIGHTLY_RIGHT
                abs(degrees) <= SIDE_DEG -> if (left) LEFT else RIGHT
                abs(degrees) <= SHARP_DEG -> if (left) SHARP_LEFT else SHARP_RIGHT
                else -> BEHIND
            }
        }

        /** Direction of a point for a wearer who stands at [from] with [heading], all in one frame. */
        fun of(from: Point, heading: Double, to: Point) = of(atan2(to.y - from.y, to.x - from.x) - heading)
    }
}

/** Sides of the belt, counter-clockwise from the front, as a wearer would call them. */
enum class Side {
    FRONT,
    FRONT_LEFT,
    LEFT,
    BACK_LEFT,
    BACK,
    BACK_RIGHT,
    RIGHT,
    FRONT_RIGHT,
    ;

    companion object {
        /** Of sensor [sensor] of [count]. */
        fun of(sensor: Int, count: Int): Side = entries[((sensor.toDouble() / count * entries.size) + 0.5).toInt() % entries.size]
    }
}
