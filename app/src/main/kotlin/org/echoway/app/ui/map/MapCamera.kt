package org.echoway.app.ui.map

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.Saver
import androidx.compose.runtime.saveable.listSaver
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import kotlin.math.PI
import org.echoway.core.Point

/** What the map keeps in its middle. */
enum class MapMode {
    /** The whole level. */
    WHOLE,

    /** The wearer. */
    FOLLOW,

    /** What the wearer's fingers moved there. */
    FREE,
}

/** Which part of a level is seen, how large, and what is up. */
@Stable
class MapCamera {
    var mode by mutableStateOf(MapMode.WHOLE)
        private set
    var headingUp by mutableStateOf(false)
        private set
    private var zoom by mutableFloatStateOf(1f)
    private var centre by mutableStateOf(Point(0.0, 0.0))

    fun view(bounds: Bounds, canvas: Size, margin: Float, wearer: WearerMark?): MapView {
        val turned = headingUp && wearer != null
        val fitting = MapView.fittingScale(bounds, canvas.width - 2 * margin, canvas.height - 2 * margin, turned)
        val middle = when (mode) {
            MapMode.WHOLE -> bounds.middle
            MapMode.FOLLOW -> wearer?.at ?: bounds.middle
            MapMode.FREE -> centre
        }
        val turn = if (turned) PI / 2 - Math.toRadians(wearer.headingDegrees.toDouble()) else 0.0
        return MapView(middle, fitting * zoom, turn, Offset(canvas.width / 2, canvas.height / 2))
    }

    /** Two fingers spread by [factor], or one moved by [pan] pixels, while [view] was shown. */
    fun gesture(view: MapView, pan: Offset, factor: Float) {
        zoomBy(factor)
        if (pan == Offset.Zero) return
        centre = view.moved(-pan)
        mode = MapMode.FREE
    }

    fun zoomBy(factor: Float) {
        zoom = (zoom * factor).coerceIn(1f, MOST_ZOOM)
    }

    /** A part of the level that is too small to be told apart is shown larger. */
    fun follow() {
        mode = MapMode.FOLLOW
        zoom = zoom.coerceAtLeast(FOLLOW_ZOOM)
    }

    fun showAll() {
        mode = MapMode.WHOLE
        zoom = 1f
    }

    fun turnUp(heading: Boolean) {
        headingUp = heading
    }

    companion object {
        const val MOST_ZOOM = 40f
        private const val FOLLOW_ZOOM = 2f

        internal val SAVER: Saver<MapCamera, Any> = listSaver(
            save = { listOf(it.mode.ordinal, it.headingUp, it.zoom, it.centre.x, it.centre.y) },
            restore = { saved ->
                MapCamera().apply {
                    mode = MapMode.entries[saved[0] as Int]
                    headingUp = saved[1] as Boolean
                    zoom = saved[2] as Float
                    centre = Point(saved[3] as Double, saved[4] as Double)
                }
            },
        )
    }
}

/** Outlives a turn of the phone. */
@Composable
fun rememberMapCamera(): MapCamera = rememberSaveable(saver = MapCamera.SAVER) { MapCamera() }

private val Bounds.middle get() = Point((left + right) / 2, (bottom + top) / 2)
