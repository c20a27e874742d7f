package org.echoway.app.ui.belt

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.size
import androidx.compose.material3.ColorScheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.unit.dp
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.min
import kotlin.math.sin
import org.echoway.core.Element
import org.echoway.core.ExplainedEcho

/** Colours of the belt's picture. No meaning hangs on them alone: each kind of reflector has its own shape. */
internal data class BeltColours(
    val wearer: Color,
    val beam: Color,
    val rings: Color,
    val explained: Color,
    val unexplained: Color,
) {
    companion object {
        fun of(scheme: ColorScheme) =
            BeltColours(scheme.primary, scheme.outline, scheme.outlineVariant, scheme.onSurface, scheme.error)
    }
}

/** The wearer in the middle, front up, and a mark for each reading as far away as it was heard. */
internal fun DrawScope.drawBelt(scan: List<ExplainedEcho>, colours: BeltColours) {
    val reach = (scan.maxOfOrNull { it.rangeM ?: 0.0 } ?: 0.0).coerceIn(LEAST_REACH_M, MOST_REACH_M)
    val outer = min(size.width, size.height) / 2 - 14.dp.toPx()
    val inner = BODY.toPx()
    val dashes = PathEffect.dashPathEffect(floatArrayOf(4.dp.toPx(), 8.dp.toPx()))
    for (ring in 1..RINGS) {
        drawCircle(
            colours.rings, inner + (outer - inner) * ring / RINGS, style = Stroke(1.dp.toPx(), pathEffect = dashes),
        )
    }
    scan.forEachIndexed { index, echo ->
        val range = echo.rangeM
        val far = if (range == null) outer else inner + (outer - inner) * (range / reach).coerceAtMost(1.0).toFloat()
        val end = around(index, scan.size, far)
        drawLine(
            colours.beam,
            around(index, scan.size, inner),
            end,
            2.dp.toPx(),
            StrokeCap.Round,
            if (range == null) dashes else null,
        )
        if (range != null) {
            drawMark(echo.element, end, if (echo.element == Element.NONE) colours.unexplained else colours.explained)
        }
    }
    drawCircle(colours.wearer, inner * 0.8f)
    drawLine(colours.wearer, center, Offset(center.x, center.y - inner * 1.4f), 6.dp.toPx(), StrokeCap.Round)
}

private fun DrawScope.around(index: Int, count: Int, radius: Float): Offset {
    val angle = PI / 2 + 2 * PI * index / count
    return Offset(center.x + (radius * cos(angle)).toFloat(), center.y - (radius * sin(angle)).toFloat())
}

/** Disc: wall. Square: corner. Triangle: edge. Diamond: reflector. Cross: nothing mapped. */
private fun DrawScope.drawMark(element: Element, at: Offset, colour: Color) {
    val r = MARK.toPx()
    when (element) {
        Element.WALL -> drawCircle(colour, r, at)
        Element.CORNER -> drawRect(colour, Offset(at.x - r, at.y - r), Size(2 * r, 2 * r))
        Element.EDGE ->
            drawShape(colour, listOf(Offset(at.x, at.y - r), Offset(at.x + r, at.y + r), Offset(at.x - r, at.y + r)))
        Element.REFLECTOR ->
            (1.3f * r).let { d ->
                drawShape(
                    colour,
                    listOf(
                        Offset(at.x, at.y - d), Offset(at.x + d, at.y), Offset(at.x, at.y + d), Offset(at.x - d, at.y),
                    ),
                )
            }
        Element.NONE -> {
            drawLine(colour, Offset(at.x - r, at.y - r), Offset(at.x + r, at.y + r), 3.dp.toPx(), StrokeCap.Round)
            drawLine(colour, Offset(at.x - r, at.y + r), Offset(at.x + r, at.y - r), 3.dp.toPx(), StrokeCap.Round)
        }
    }
}

private fun DrawScope.drawShape(colour: Color, corners: List<Offset>) = drawPath(
    Path().apply {
        corners.forEachIndexed { i, p -> if (i == 0) moveTo(p.x, p.y) else lineTo(p.x, p.y) }
        close()
    },
    colour,
)

/** What the marks mean. */
@Composable
internal fun Legend(colours: BeltColours) {
    Element.entries.forEach { element ->
        Row(horizontalArrangement = Arrangement.spacedBy(12.dp), verticalAlignment = Alignment.CenterVertically) {
            Canvas(Modifier.size(24.dp)) {
                drawMark(element, center, if (element == Element.NONE) colours.unexplained else colours.explained)
            }
            Text(stringResource(element.words), style = MaterialTheme.typography.bodyLarge)
        }
    }
}

private const val RINGS = 4
private const val LEAST_REACH_M = 2.0

/** What the sensors reach: 35 ft. */
private const val MOST_REACH_M = 10.67
private val BODY = 26.dp
private val MARK = 6.dp
