package org.echoway.app.ui.map

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.size
import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.OutlinedIconButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.ui.common.Action

/**
 * What two fingers do, for who cannot use them, and what is up.
 *
 * @param levels to go through; one needs no button
 */
@Composable
fun MapControls(
    camera: MapCamera,
    wearerKnown: Boolean,
    levels: List<Int>,
    level: Int,
    onLevel: (Int) -> Unit,
    modifier: Modifier = Modifier,
) {
    FlowRow(modifier, Arrangement.spacedBy(8.dp, Alignment.CenterHorizontally)) {
        Control(R.string.map_zoom_out, { camera.zoomBy(1 / STEP) }) { drawBar(it) }
        Control(R.string.map_zoom_in, { camera.zoomBy(STEP) }) {
            drawBar(it)
            drawLine(
                it,
                Offset(center.x, size.height * 0.15f),
                Offset(center.x, size.height * 0.85f),
                LINE.toPx(),
                StrokeCap.Round,
            )
        }
        if (camera.mode != MapMode.WHOLE || !wearerKnown) {
            Control(R.string.map_whole, camera::showAll) {
                drawRect(it, Offset(size.width * 0.15f, size.height * 0.15f), size * 0.7f, style = Stroke(LINE.toPx()))
            }
        }
        if (wearerKnown && camera.mode != MapMode.FOLLOW) {
            Control(R.string.map_follow, camera::follow) {
                drawCircle(it, size.width * 0.38f, style = Stroke(LINE.toPx()))
                drawCircle(it, size.width * 0.14f)
            }
        }
        if (wearerKnown) {
            val up = camera.headingUp
            Control(if (up) R.string.map_north_up else R.string.map_heading_up, { camera.turnUp(!up) }) {
                if (up) drawNorth(it) else drawArrow(it)
            }
        }
        if (levels.size > 1) {
            Action(stringResource(R.string.map_level, level), Modifier) {
                onLevel(levels[(levels.indexOf(level) + 1) % levels.size])
            }
        }
    }
}

@Composable
private fun Control(name: Int, onClick: () -> Unit, draw: DrawScope.(Color) -> Unit) {
    val said = stringResource(name)
    OutlinedIconButton(onClick, Modifier.size(52.dp).semantics { contentDescription = said }) {
        val colour = LocalContentColor.current
        Canvas(Modifier.size(24.dp)) { draw(colour) }
    }
}

private fun DrawScope.drawBar(colour: Color) =
    drawLine(
        colour,
        Offset(size.width * 0.15f, center.y),
        Offset(size.width * 0.85f, center.y),
        LINE.toPx(),
        StrokeCap.Round,
    )

/** The wearer's arrow, upright. */
private fun DrawScope.drawArrow(colour: Color) = drawPath(
    Path().apply {
        moveTo(center.x, 0f)
        lineTo(size.width * 0.9f, size.height)
        lineTo(center.x, size.height * 0.7f)
        lineTo(size.width * 0.1f, size.height)
        close()
    },
    colour,
)

/** A compass needle. */
private fun DrawScope.drawNorth(colour: Color) {
    val needle = Path().apply {
        moveTo(center.x, 0f)
        lineTo(size.width * 0.7f, center.y)
        lineTo(size.width * 0.3f, center.y)
        close()
    }
    drawPath(needle, colour)
    val tail = Path().apply {
        moveTo(center.x, size.height)
        lineTo(size.width * 0.7f, center.y)
        lineTo(size.width * 0.3f, center.y)
        close()
    }
    drawPath(tail, colour, style = Stroke(LINE.toPx() / 2))
}

private const val STEP = 1.5f
private val LINE = 3.dp
