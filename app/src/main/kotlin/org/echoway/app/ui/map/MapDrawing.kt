package org.echoway.app.ui.map

import androidx.compose.material3.ColorScheme
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.PathFillType
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.rotate
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.unit.dp
import kotlin.math.abs
import kotlin.math.max
import org.echoway.core.Point

/** Colours of a map. No meaning hangs on them alone: doors, exits, places, way and trail have shapes of their own. */
internal data class MapColours(
    val floor: Color,
    val here: Color,
    val wall: Color,
    val door: Color,
    val label: Color,
    val wearer: Color,
    val way: Color,
    val trail: Color,
) {
    companion object {
        fun of(scheme: ColorScheme) = MapColours(
            floor = scheme.surfaceVariant,
            here = scheme.primaryContainer,
            wall = scheme.onSurface,
            door = scheme.tertiary,
            label = scheme.onSurfaceVariant,
            wearer = scheme.primary,
            way = scheme.primary,
            trail = scheme.outline,
        )
    }
}

internal fun DrawScope.drawRooms(drawing: LevelDrawing, view: MapView, colours: MapColours, here: Int?) {
    for (room in drawing.rooms) {
        val floor = Path().apply { fillType = PathFillType.EvenOdd }
        for (loop in room.boundary) {
            loop.forEachIndexed { i, p ->
                view(p).let { if (i == 0) floor.moveTo(it.x, it.y) else floor.lineTo(it.x, it.y) }
            }
            floor.close()
        }
        drawPath(floor, if (room.index == here) colours.here else colours.floor)
    }
    for (room in drawing.rooms) {
        for (wall in room.walls) drawLine(colours.wall, view(wall.a), view(wall.b), WALL.toPx(), StrokeCap.Round)
    }
}

internal fun DrawScope.drawDoors(drawing: LevelDrawing, view: MapView, colours: MapColours) {
    // The floor's colour first: it opens the walls that run through the doorway.
    for (door in drawing.doors) drawLine(colours.floor, view(door.a), view(door.b), DOORWAY.toPx())
    for (door in drawing.doors) drawLine(colours.door, view(door.a), view(door.b), DOOR.toPx())
}

/**
 * The wearer's own room goes without: its name stands below the map, and the wearer would hide it. A name that would
 * lie on one of [places] moves below it.
 */
internal fun DrawScope.drawLabels(
    rooms: List<DrawnRoom>,
    places: List<Point>,
    view: MapView,
    colours: MapColours,
    measurer: TextMeasurer,
    style: TextStyle,
) {
    val marks = places.map(view::invoke)
    for (room in rooms) {
        val lines = listOf(room.id, room.name).filter { it.isNotEmpty() }.distinctBy { it.lowercase() }
        val width = view.scale * room.width - 2 * LABEL_MARGIN.toPx()
        // A name that does not fit its room would be taken for its neighbour's.
        val fitting = lines.map { measurer.measure(it, style) }.filter { it.size.width <= width }
        val middle = view(room.middle)
        val height = fitting.sumOf { it.size.height }
        val below = PLACE.toPx() * 1.5f
        val hidden = marks.firstOrNull {
            abs(it.x - middle.x) < LABEL_REACH.toPx() && abs(it.y - middle.y) < height / 2f + below
        }
        var top = hidden?.let { it.y + below } ?: (middle.y - height / 2f)
        for (layout in fitting) {
            drawText(layout, colours.label, Offset(middle.x - layout.size.width / 2f, top))
            top += layout.size.height
        }
    }
}

/** Exits: an arrow out of the building, in a disc. */
internal fun DrawScope.drawExits(exits: List<ExitMark>, view: MapView, colours: MapColours) {
    for (exit in exits) {
        val at = view(exit.at)
        val r = EXIT.toPx()
        drawCircle(colours.wall, r, at)
        rotate(-Math.toDegrees(exit.outwards + view.turn).toFloat(), at) {
            val tip = Offset(at.x + 0.5f * r, at.y)
            drawLine(colours.floor, Offset(at.x - 0.55f * r, at.y), tip, 2.dp.toPx(), StrokeCap.Round)
            drawLine(colours.floor, tip, Offset(at.x + 0.05f * r, at.y - 0.45f * r), 2.dp.toPx(), StrokeCap.Round)
            drawLine(colours.floor, tip, Offset(at.x + 0.05f * r, at.y + 0.45f * r), 2.dp.toPx(), StrokeCap.Round)
        }
    }
}

/** Places: a diamond. */
internal fun DrawScope.drawPlaces(places: List<Point>, view: MapView, colours: MapColours) {
    for (place in places) {
        val at = view(place)
        val r = PLACE.toPx()
        val diamond = Path().apply {
            moveTo(at.x, at.y - r)
            lineTo(at.x + r, at.y)
            lineTo(at.x, at.y + r)
            lineTo(at.x - r, at.y)
            close()
        }
        drawPath(diamond, colours.floor)
        drawPath(diamond, colours.wall, style = Stroke(2.dp.toPx()))
    }
}

/** Where the wearer came along: dots. */
internal fun DrawScope.drawTrail(trail: List<Point>, view: MapView, colours: MapColours) {
    for (crumb in trail) drawCircle(colours.trail, CRUMB.toPx(), view(crumb))
}

/** The way to go: a broad line with a light seam, so that it is seen on walls and floors. */
internal fun DrawScope.drawWay(legs: List<List<Point>>, view: MapView, colours: MapColours) {
    for (leg in legs) {
        val path = Path()
        leg.forEachIndexed { i, p -> view(p).let { if (i == 0) path.moveTo(it.x, it.y) else path.lineTo(it.x, it.y) } }
        drawPath(
            path,
            colours.floor,
            style = Stroke(WAY.toPx() + 3.dp.toPx(), cap = StrokeCap.Round, join = StrokeJoin.Round),
        )
        val dashes = PathEffect.dashPathEffect(floatArrayOf(12.dp.toPx(), 6.dp.toPx()))
        drawPath(
            path,
            colours.way,
            style = Stroke(WAY.toPx(), cap = StrokeCap.Butt, join = StrokeJoin.Round, pathEffect = dashes),
        )
        val goal = view(leg.last())
        drawCircle(colours.floor, WAY.toPx() * 2f, goal)
        drawCircle(colours.way, WAY.toPx() * 1.6f, goal)
    }
}

internal fun DrawScope.drawWearer(mark: WearerMark, view: MapView, colours: MapColours) {
    val at = view(mark.at)
    val turn = Math.toDegrees(view.turn).toFloat()
    val radii = Size(2 * mark.majorM * view.scale, 2 * mark.minorM * view.scale)
    rotate(-mark.majorDegrees - turn, at) {
        val corner = Offset(at.x - radii.width / 2, at.y - radii.height / 2)
        drawOval(colours.wearer.copy(alpha = 0.25f), corner, radii)
        drawOval(colours.wearer, corner, radii, style = Stroke(1.dp.toPx()))
    }
    val size = ARROW.toPx()
    rotate(-mark.headingDegrees - turn, at) {
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

private val WALL = 2.dp
private val DOOR = 3.dp
private val DOORWAY = 6.dp
private val ARROW = 12.dp
private val LABEL_MARGIN = 4.dp
private val LABEL_REACH = 24.dp
private val EXIT = 9.dp
private val PLACE = 5.dp
private val CRUMB = 2.dp
private val WAY = 4.dp
