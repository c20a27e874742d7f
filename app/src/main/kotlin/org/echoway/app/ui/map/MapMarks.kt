package org.echoway.app.ui.map

import kotlin.math.atan2
import org.echoway.app.engine.Picture
import org.echoway.core.Landmark
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Spot

/** A way out; [outwards] is where it leads, radians in the level's frame. */
class ExitMark(val at: Point, val outwards: Double)

/** What lies on a level besides its rooms, in the level's frame. */
class MapMarks(val exits: List<ExitMark>, val places: List<Point>, val trail: List<Point>, val way: List<List<Point>>) {
    companion object {
        fun of(plan: Plan, level: Int, picture: Picture): MapMarks {
            fun at(spot: Spot): Point? =
                plan.rooms.getOrNull(spot.room)?.takeIf { it.level == level }?.frame?.toLevel(spot.at)
            fun exit(landmark: Landmark): ExitMark? {
                val point = at(landmark.spot) ?: return null
                val inside = plan.rooms[landmark.spot.room].middle()
                return ExitMark(point, atan2(point.y - inside.y, point.x - inside.x))
            }
            return MapMarks(
                plan.exits.mapNotNull(::exit),
                plan.places.mapNotNull { at(it.spot) },
                picture.breadcrumbs.mapNotNull(::at),
                way(picture, ::at),
            )
        }

        /** A way that leaves the level and comes back is several lines. */
        private fun way(picture: Picture, at: (Spot) -> Point?): List<List<Point>> {
            val legs = mutableListOf<MutableList<Point>>()
            var open: MutableList<Point>? = null
            for (waypoint in picture.route.waypoints) {
                for (spot in listOfNotNull(waypoint.spot, waypoint.next)) {
                    val point = at(spot)
                    if (point == null) {
                        open = null
                    } else {
                        (open ?: mutableListOf<Point>().also { open = it; legs += it }) += point
                    }
                }
            }
            return legs.filter { it.size > 1 }
        }
    }
}
