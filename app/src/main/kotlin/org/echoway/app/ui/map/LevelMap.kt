package org.echoway.app.ui.map

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.gestures.detectTransformGestures
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.layout.onSizeChanged
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.LocalResources
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.traversalIndex
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.toSize
import kotlin.math.roundToInt
import org.echoway.app.engine.Picture
import org.echoway.core.Estimate
import org.echoway.core.LengthStyle
import org.echoway.core.Plan
import org.echoway.core.Point

/**
 * One level of a floor plan with its walls, doors, places and exits, the wearer, the trail behind and the way ahead.
 * Fingers move and spread it. A screen reader reads it as a sentence, then room by room, the nearest first, and finds a
 * room under the finger.
 */
@Composable
fun LevelMap(
    title: String,
    plan: Plan,
    level: Int,
    wearer: Estimate?,
    picture: Picture,
    lengths: LengthStyle,
    camera: MapCamera,
    modifier: Modifier = Modifier,
) {
    val resources = LocalResources.current
    val drawing = remember(plan, level) { LevelDrawing.of(plan, level) }
    val marks = remember(plan, level, picture) { MapMarks.of(plan, level, picture) }
    val words = remember(title, plan, resources, lengths) { MapWords(resources, title, plan, lengths) }
    val mark = wearer?.takeIf { plan.rooms.getOrNull(it.room)?.level == level }?.let { WearerMark.of(plan, it) }
    var canvas by remember { mutableStateOf(Size.Zero) }
    val margin = with(LocalDensity.current) { MARGIN.toPx() }
    val view = camera.view(drawing.bounds, canvas, margin, mark)
    val shown by rememberUpdatedState(view)
    val way = picture.route.lengthM.takeIf { picture.route.waypoints.isNotEmpty() }
    Box(
        modifier
            .clipToBounds()
            .onSizeChanged { canvas = it.toSize() }
            .pointerInput(camera) { detectTransformGestures { _, pan, zoom, _ -> camera.gesture(shown, pan, zoom) } }
            .semantics { isTraversalGroup = true },
    ) {
        MapCanvas(drawing, marks, mark, wearer?.room, view, words.sentence(level, wearer, way))
        if (canvas != Size.Zero) RoomNodes(drawing, view, canvas, mark?.at) { words.room(it, wearer) }
    }
}

@Composable
private fun MapCanvas(
    drawing: LevelDrawing,
    marks: MapMarks,
    mark: WearerMark?,
    here: Int?,
    view: MapView,
    sentence: String,
) {
    val colours = MapColours.of(MaterialTheme.colorScheme)
    val measurer = rememberTextMeasurer(LABELS_KEPT)
    val style = MaterialTheme.typography.labelMedium
    Canvas(
        Modifier.fillMaxSize().semantics {
            contentDescription = sentence
            traversalIndex = -1f
        },
    ) {
        drawRooms(drawing, view, colours, here)
        drawDoors(drawing, view, colours)
        drawLabels(drawing.rooms.filter { it.index != here }, marks.places, view, colours, measurer, style)
        drawExits(marks.exits, view, colours)
        drawPlaces(marks.places, view, colours)
        drawTrail(marks.trail, view, colours)
        drawWay(marks.way, view, colours)
        if (mark != null) drawWearer(mark, view, colours)
    }
}

/** Nothing to see: what a screen reader finds where a room is drawn. */
@Composable
private fun RoomNodes(drawing: LevelDrawing, view: MapView, canvas: Size, from: Point?, words: (Int) -> String) {
    val seen = drawing.rooms.mapNotNull { room -> room.seen(view, canvas)?.let { room to it } }
        .sortedBy { (room, _) -> from?.distanceTo(room.middle) ?: 0.0 }
    Layout(
        content = {
            seen.forEachIndexed { order, (room, _) ->
                Box(
                    Modifier.semantics {
                        // Put into words only when something asks.
                        contentDescription = words(room.index)
                        traversalIndex = order.toFloat()
                    },
                )
            }
        },
    ) { measurables, constraints ->
        val boxes = seen.map { it.second }
        val placeables = measurables.mapIndexed { i, each ->
            each.measure(
                Constraints.fixed(
                    boxes[i].width.roundToInt().coerceAtLeast(1), boxes[i].height.roundToInt().coerceAtLeast(1),
                ),
            )
        }
        layout(constraints.maxWidth, constraints.maxHeight) {
            placeables.forEachIndexed { i, each -> each.place(boxes[i].left.roundToInt(), boxes[i].top.roundToInt()) }
        }
    }
}

/** Where a room is on the canvas; null when it is outside. */
private fun DrawnRoom.seen(view: MapView, canvas: Size): Rect? {
    val corners = listOf(
        bounds.left to bounds.bottom,
        bounds.right to bounds.bottom,
        bounds.right to bounds.top,
        bounds.left to bounds.top,
    )
        .map { (x, y) -> view(Point(x, y)) }
    val box = Rect(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })
    return box.intersect(Rect(0f, 0f, canvas.width, canvas.height)).takeIf { it.width > 0 && it.height > 0 }
}

/** More than the rooms of a large level have names and numbers. */
private const val LABELS_KEPT = 256
private val MARGIN = 16.dp
