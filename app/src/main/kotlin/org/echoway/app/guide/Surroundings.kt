package org.echoway.app.guide

import kotlin.math.PI
import kotlin.math.IEEErem
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin
import org.echoway.core.Estimate
import org.echoway.core.Landmark
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Wall

/** What is around a wearer who stands where an estimate says, in the words' terms. REQUIRES: the estimate has a room. */
class Surroundings(private val plan: Plan, private val estimate: Estimate) {
    private val here = Point(estimate.x, estimate.y)
    private val room = plan.rooms[estimate.room]

    /** Doors of this room as the wearer sees them, the nearest first. */
    val doors: List<Pair<Int, Seen>> = plan.doors.withIndex()
        .mapNotNull { (index, door) -> door.seenFrom(estimate.room)?.let { index to see(it) } }
        .sortedBy { it.second.distanceM }

    /** Places and exits of this room, the nearest first. */
    val places: List<NamedSeen> = (plan.places + plan.exits)
        .filter { it.spot.room == estimate.room && it.name.isNotEmpty() }
        .map(::see)
        .sortedBy { it.seen.distanceM }

    fun answer() = Answer.Here(room, facing(), doors.firstOrNull()?.second, places.firstOrNull { it.seen.distanceM <= PLACE_REACH_M })

    private fun see(landmark: Landmark) = NamedSeen(landmark.name, see(landmark.spot.at))

    private fun see(point: Point) = Seen(Direction.of(here, estimate.heading, point), here.distanceTo(point), estimate.sigmaM)

    private fun facing(): Facing? {
        val wallM = wallAhead() ?: return null
        val doorAhead = plan.doors.any { door -> door.seenFrom(estimate.room)?.let { isAhead(it, door.width / 2) } == true }
        if (doorAhead) return Facing.Door
        val place = places.firstOrNull { it.seen.direction == Direction.AHEAD && it.seen.distanceM < wallM }
        return place?.let { Facing.Place(it.name) } ?: Facing.Wall(wallM, estimate.sigmaM)
    }

    /** Whether the wearer looks at something of this half width. */
    private fun isAhead(point: Point, halfWidth: Double): Boolean {
        val bearing = (atan2(point.y - here.y, point.x - here.x) - estimate.heading).IEEErem(2 * PI)
        return abs(bearing) < PI / 2 && abs(sin(bearing)) * here.distanceTo(point) <= halfWidth
    }

    private fun wallAhead(): Double? = room.walls.mapNotNull(::distanceAlongHeading).minOrNull()

    private fun distanceAlongHeading(wall: Wall): Double? {
        val dx = cos(estimate.heading)
        val dy = sin(estimate.heading)
        val edge = wall.b - wall.a
        val crossing = dx * edge.y - dy * edge.x
        if (abs(crossing) < PARALLEL) return null
        val to = wall.a - here
        val along = (to.x * edge.y - to.y * edge.x) / crossing
        val share = (to.x * dy - to.y * dx) / crossing
        return along.takeIf { it > 0 && share in 0.0..1.0 }
    }

    companion object {
        /** A place this near is worth a word. */
        const val PLACE_REACH_M = 3.0
        private const val PARALLEL = 1e-9
    }
}
