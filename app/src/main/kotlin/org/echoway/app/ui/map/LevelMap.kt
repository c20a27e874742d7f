package org.echoway.app.ui.map

import androidx.compose.foundation.Canvas
import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathFillType
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.rotate
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import kotlin.math.max
import org.echoway.core.Estimate
import org.echoway.core.Plan

/** Colours of a map. */
data class MapColours(val floor: Color, val here: Color, val wall: Color, val door: Color, val label: Color, val wearer: Color)

/** One level of a floor plan with its walls, doors and rooms' names, and the wearer where they are. */
@Composable
fun LevelMap(plan: Plan, level: Int, wearer: Estimate?, description: String, modifier: Modifier = Modifier) {
    val drawing = remember(plan, level) { LevelDrawing.of(plan, level) }
    val scheme = MaterialTheme.colorScheme
    val colours = MapColours(
        floor = scheme.surfaceVariant,
        here = scheme.primaryContainer,
        wall = scheme.onSurface,
        door = scheme.tertiary,
        label = scheme.onSurfaceVariant,
        wearer = scheme.primary,
    )
    val measurer = rememberTextMeasurer()
    val labelStyle = MaterialTheme.typography.labelMedium
    Canvas(modifier.semantics { contentDescription = description }) {
        val view = MapView.fitting(drawing.bounds, size.width, size.height, MARGIN.toPx())
        drawRooms(drawing, view, colours, wearer?.room)
        drawDoors(drawing, view, colours)
        drawLabels(drawing.rooms.filter { it.index != wearer?.room }, view, colours, measurer, labelStyle)
        if (wearer != null && plan.rooms.getOrNull(wearer.room)?.level == level) drawWearer(WearerMark.of(plan, wearer), view, colours)
    }
}

private fun DrawScope.drawRooms(drawing: LevelDrawing, view: MapView, colours: MapColours, here: Int?) {
    for (room in drawing.rooms) {
        val floor = Path().apply { fillType = PathFillType.EvenOdd }
        for (loop in room.boundary) {
            loop.forEachIndexed { i, p -> view(p).let { if (i == 0) floor.moveTo(it.x, it.y) else floor.lineTo(it.x, it.y) } }
            floor.close()
        }
        drawPath(floor, if (room.index == here) colours.here else colours.floor)
    }
    for (room in drawing.rooms) {
        for (wall in room.walls) drawLine(colours.wall, view(wall.a), view(wall.b), WALL.toPx(), StrokeCap.Round)
    }
}

private fun DrawScope.drawDoors(drawing: LevelDrawing, view: MapView, colours: MapColours) {
    // The floor's colour first: it opens the walls that run through the doorway.
    for (door in drawing.doors) drawLine(colours.floor, view(door.a), view(door.b), DOORWAY.toPx())
    for (door in drawing.doors) drawLine(colours.door, view(door.a), view(door.b), DOOR.toPx())
}

/** The wearer's own room goes without: its name stands below the map, and the wearer would hide it. */
private fun DrawScope.drawLabels(rooms: List<DrawnRoom>, view: MapView, colours: MapColours, measurer: TextMeasurer, style: TextStyle) {
    for (room in rooms) {
        val lines = listOf(room.id, room.name).filter { it.isNotEmpty() }.distinctBy { it.lowercase() }
        val layouts = lines.map { measurer.measure(it, style) }
        val width = view.scale * room.width - 2 * LABEL_MARGIN.toPx()
        // A name that does not fit its room would be taken for its neighbour's.
        val fitting = layouts.filter { it.size.width <= width }
        var top = view(room.middle).y - fitting.sumOf { it.size.height } / 2f
        for (layout in fitting) {
            drawText(layout, colours.label, Offset(view(room.middle).x - layout.size.width / 2f, top))
            top += layout.size.height
        }
    }
}

private fun DrawScope.drawWearer(mark: WearerMark, view: MapView, colours: MapColours) {
    val at = view(mark.at)
    val radii = Size(2 * mark.majorM * view.scale, 2 * mark.minorM * view.scale)
    rotate(-mark.majorDegrees, at) {
        val corner = Offset(at.x - radii.width / 2, at.y - radii.height / 2)
        drawOval(colours.wearer.copy(alpha = 0.25f), corner, radii)
        drawOval(colours.wearer, corner, radii, style = Stroke(1.dp.toPx()))
    }
    val size = ARROW.toPx()
    rotate(-mark.headingDegrees, at) {
        val arrow = Path().apply {
            moveTo(at.x + size, at.y)
            lineTo(at.x - size * 0.7f, at.y - size * 0.7f)
            lineTo(at.x - size * 0.3f, at.y)
            lineTo(at.x - size * 0.7f, at.y + size * 0.7f)
            close()
        }
        drawPath(arrow, colours.wearer)
        drawPath(arrow, colours.floor, style = Stroke(max(1f, 1.5.dp.toPx())))
    }
}

private val MARGIN = 16.dp
private val WALL = 2.dp
private val DOOR = 3.dp
private val DOORWAY = 6.dp
private val ARROW = 12.dp
private val LABEL_MARGIN = 4.dp
