package org.echoway.app.motion

import kotlin.math.sqrt

/**
 * Turn rate about the vertical from a gyroscope's three axes and the direction of gravity, averaged over a short while.
 */
internal class YawRate {
    private val up = DoubleArray(AXES)
    private var levelled = false
    private var sum = 0.0
    private var count = 0
    private var dueS = Double.NEGATIVE_INFINITY

    /** Android's gravity points up: a phone flat on a table reads +9.81 on its z axis. */
    fun gravity(values: FloatArray) {
        val norm = sqrt((0 until AXES).sumOf { values[it].toDouble() * values[it] })
        if (norm < MIN_GRAVITY) return
        for (axis in 0 until AXES) up[axis] = values[axis] / norm
        levelled = true
    }

    /** rad/s counter-clockwise seen from above, once every [PERIOD_S]; null in between and before gravity is known. */
    fun rate(values: FloatArray, timeS: Double): Double? {
        if (!levelled) return null
        sum += (0 until AXES).sumOf { values[it] * up[it] }
        count++
        if (timeS < dueS) return null
        dueS = timeS + PERIOD_S
        return (sum / count).also {
            sum = 0.0
            count = 0
        }
    }

    companion object {
        /** A little more often than the belt fires. */
        const val PERIOD_S = 0.05
        private const val AXES = 3
        private const val MIN_GRAVITY = 1.0
    }
}
