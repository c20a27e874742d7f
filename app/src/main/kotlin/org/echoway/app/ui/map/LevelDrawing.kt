package org.echoway.app.ui.map

import kotlin.math.atan2
import kotlin.math.hypot
import kotlin.math.max
import kotlin.math.sqrt
import org.echoway.core.Door
import org.echoway.core.Estimate
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Wall

/** A rectangle of the level's frame, metres. */
data class Bounds(val left: Double, val bottom: Double, val right: Double, val top: Double)

/** A room in its level's frame. */
class DrawnRoom(
    val index: Int,
    val id: String,
    val name: String,
    val walls: List<Wall>,
    val boundary: List<List<Point>>,
) {
    private val corners = walls.flatMap { listOf(it.a, it.b) }
    val bounds = Bounds(corners.minOf { it.x }, corners.minOf { it.y }, corners.maxOf { it.x }, corners.maxOf { it.y })
    val middle = Point((bounds.left + bounds.right) / 2, (bounds.bottom + bounds.top) / 2)
    val width = (bounds.right - bounds.left).toFloat()
}

/** One level of a plan, ready to be drawn: everything in the level's frame, metres. */
class LevelDrawing(val rooms: List<DrawnRoom>, val doors: List<Wall>, val bounds: Bounds) {
    companion object {
        fun of(plan: Plan, level: Int): LevelDrawing {
            val rooms = plan.rooms.withIndex().filter { it.value.level == level }.map { (index, room) ->
                val toLevel = room.frame::toLevel
                DrawnRoom(
                    index, room.id, room.name,
                    walls = room.walls.map { Wall(toLevel(it.a), toLevel(it.b)) },
                    boundary = room.boundary.map { loop -> loop.map(toLevel) },
                )
            }
            val all = rooms.map { it.bounds }
            val bounds =
                Bounds(all.minOf { it.left }, all.minOf { it.bottom }, all.maxOf { it.right }, all.maxOf { it.top })
            val doors = plan.doors.filter { plan.rooms[it.a.room].level == level }.mapNotNull { opening(plan, it) }
            return LevelDrawing(rooms, doors, bounds)
        }

        /** A door as a line along the wall that is nearest to it. */
        private fun opening(plan: Plan, door: Door): Wall? {
            val room = plan.rooms[door.a.room]
            val wall = room.walls.filter { it.a != it.b }.minByOrNull { distance(it, door.a.at) } ?: return null
            val along = wall.b - wall.a
            val length = hypot(along.x, along.y)
            val dx = along.x / length * door.width / 2
            val dy = along.y / length * door.width / 2
            val at = door.a.at
            return Wall(
                room.frame.toLevel(Point(at.x - dx, at.y - dy)), room.frame.toLevel(Point(at.x + dx, at.y + dy)),
            )
        }

        private fun distance(wall: Wall, p: Point): Double {
            val d = wall.b - wall.a
            val t = (((p.x - wall.a.x) * d.x + (p.y - wall.a.y) * d.y) / (d.x * d.x + d.y * d.y)).coerceIn(0.0, 1.0)
            return p.distanceTo(Point(wall.a.x + t * d.x, wall.a.y + t * d.y))
        }
    }
}

/**
 * The wearer as drawn: angles counter-clockwise in degrees in the level's frame; the ellipse holds the position with a
 * probability of 0.86 (two standard deviations of a plane Gaussian).
 */
class WearerMark(
    val at: Point,
    val headingDegrees: Float,
    val majorM: Float,
    val minorM: Float,
    val majorDegrees: Float,
) {
    companion object {
        private const val SIGMAS = 2.0

        fun of(plan: Plan, e: Estimate): WearerMark {
            val frame = plan.rooms[e.room].frame
            val mean = (e.covarianceXx + e.covarianceYy) / 2
            val spread = hypot((e.covarianceXx - e.covarianceYy) / 2, e.covarianceXy)
            val axis = atan2(2 * e.covarianceXy, e.covarianceXx - e.covarianceYy) / 2
            return WearerMark(
                at = frame.toLevel(Point(e.x, e.y)),
                headingDegrees = Math.toDegrees(e.heading + frame.heading).toFloat(),
                majorM = (SIGMAS * sqrt(max(0.0, mean + spread))).toFloat(),
                minorM = (SIGMAS * sqrt(max(0.0, mean - spread))).toFloat(),
                majorDegrees = Math.toDegrees(axis + frame.heading).toFloat(),
            )
        }
    }
}
