package org.echoway.app.ui.diagnostics

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.platform.LocalResources
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.min
import kotlin.math.sin
import org.echoway.app.R
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Subheading
import org.echoway.core.BeltHealth
import org.echoway.core.SensorHealth

/** How belt and sensors do, as a picture and in words. */
@Composable
fun DiagnosticsScreen(belt: BeltHealth, onCopy: (BeltHealth) -> Unit, onBack: () -> Unit) {
    val resources = LocalResources.current
    val report = remember(resources) { DiagnosticsReport(resources) }
    Screen(stringResource(R.string.diagnostics), onBack) {
        Text(report.summary(belt), style = MaterialTheme.typography.titleMedium)
        if (belt.sensors.isNotEmpty()) {
            SensorRing(
                belt.sensors,
                report.summary(belt),
                Modifier.widthIn(max = 360.dp).fillMaxWidth().aspectRatio(1f).align(Alignment.CenterHorizontally),
            )
        }
        Action(stringResource(R.string.copy_report)) { onCopy(belt) }
        Subheading(stringResource(R.string.belt))
        report.belt(belt).forEach { Text(it, style = MaterialTheme.typography.bodyLarge) }
        if (belt.sensors.isNotEmpty()) Subheading(stringResource(R.string.sensors))
        belt.sensors.indices.forEach {
            Text(report.sensor(it, belt.sensors), style = MaterialTheme.typography.bodyLarge)
        }
    }
}

/**
 * The belt from above, front up: a filled disc for a good sensor, a cross for one in trouble, a ring for one
 * not heard of.
 */
@Composable
private fun SensorRing(sensors: List<SensorHealth>, description: String, modifier: Modifier) {
    val scheme = MaterialTheme.colorScheme
    val measurer = rememberTextMeasurer()
    val style = MaterialTheme.typography.labelLarge
    Canvas(modifier.semantics { contentDescription = description }) {
        val labels = style.fontSize.toPx() * 1.5f + MARK.toPx()
        val radius = min(size.width, size.height) / 2 - labels - MARK.toPx()
        drawCircle(scheme.outline, radius, style = Stroke(2.dp.toPx()))
        drawLine(scheme.onSurface, center, Offset(center.x, center.y - radius / 2), 3.dp.toPx(), StrokeCap.Round)
        sensors.forEachIndexed { index, sensor ->
            val at = around(index, sensors.size, radius)
            drawCircle(scheme.surface, MARK.toPx(), at)
            when {
                sensor.state.isTrouble -> drawCross(scheme.error, at)
                sensor.firings == 0 -> drawCircle(scheme.outline, MARK.toPx(), at, style = Stroke(2.dp.toPx()))
                else -> drawCircle(scheme.primary, MARK.toPx(), at)
            }
            val label = measurer.measure("${index + 1}", style)
            val outside = around(index, sensors.size, radius + labels)
            drawText(
                label, scheme.onSurface, Offset(outside.x - label.size.width / 2, outside.y - label.size.height / 2),
            )
        }
    }
}

private fun DrawScope.around(index: Int, count: Int, radius: Float): Offset {
    val angle = PI / 2 + 2 * PI * index / count
    return Offset(center.x + (radius * cos(angle)).toFloat(), center.y - (radius * sin(angle)).toFloat())
}

private fun DrawScope.drawCross(colour: Color, at: Offset) {
    val r = MARK.toPx()
    drawLine(colour, Offset(at.x - r, at.y - r), Offset(at.x + r, at.y + r), 4.dp.toPx(), StrokeCap.Round)
    drawLine(colour, Offset(at.x - r, at.y + r), Offset(at.x + r, at.y - r), 4.dp.toPx(), StrokeCap.Round)
}

private val MARK = 9.dp
