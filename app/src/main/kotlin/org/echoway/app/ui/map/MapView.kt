package org.echoway.app.ui.map

import androidx.compose.ui.geometry.Offset
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.max
import kotlin.math.min
import kotlin.math.sin
import org.echoway.core.Point

/**
 * Takes metres of a level to pixels, y up.
 *
 * @property centre what stands at [middle]
 * @property scale pixels a metre
 * @property turn by which the level is turned counter-clockwise, radians
 */
class MapView(val centre: Point, val scale: Float, val turn: Double, private val middle: Offset) {
    private val c = cos(turn)
    private val s = sin(turn)

    operator fun invoke(p: Point): Offset {
        val d = p - centre
        return Offset(
            middle.x + ((c * d.x - s * d.y) * scale).toFloat(), middle.y - ((s * d.x + c * d.y) * scale).toFloat(),
        )
    }

    /** The point of the level that lies as far from [centre] as [pixels] from the middle. */
    fun moved(pixels: Offset): Point {
        val x = pixels.x / scale
        val y = -pixels.y / scale
        return Point(centre.x + c * x + s * y, centre.y - s * x + c * y)
    }

    companion object {
        /** All of the level in a canvas, as large as fits; a level that may be turned needs room for its diagonal. */
        fun fittingScale(bounds: Bounds, width: Float, height: Float, turned: Boolean): Float {
            val across = max(bounds.right - bounds.left, MIN_EXTENT_M)
            val up = max(bounds.top - bounds.bottom, MIN_EXTENT_M)
            val scale = if (turned) min(width, height) / hypot(across, up) else min(width / across, height / up)
            return max(scale.toFloat(), LEAST_SCALE)
        }

        private const val MIN_EXTENT_M = 1.0

        /** A canvas that has no room yet. */
        private const val LEAST_SCALE = 1e-3f
    }
}
