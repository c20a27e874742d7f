package org.echoway.app.ui.map

import android.content.res.Resources
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.roundToInt
import org.echoway.app.R
import org.echoway.app.guide.Wording
import org.echoway.app.ui.common.roughLength
import org.echoway.core.Estimate
import org.echoway.core.LengthStyle
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Room

/** A level of a plan in words: as a sentence, and room by room. [title] is what a wearer calls the building. */
class MapWords(
    private val resources: Resources,
    private val title: String,
    private val plan: Plan,
    private val lengths: LengthStyle,
) {
    private val wording = Wording(resources)

    /** "Map of Torgersen laboratory, level 3. 7 rooms, 2 exits. You are in Room 4, Seminar room." */
    fun sentence(level: Int, wearer: Estimate?, wayM: Double?): String {
        val rooms = plan.rooms.count { it.level == level }
        val exits = plan.exits.count { plan.rooms[it.spot.room].level == level }
        val size = resources.getString(
            R.string.building_size,
            resources.getQuantityString(R.plurals.rooms, rooms, rooms),
            resources.getQuantityString(R.plurals.exits, exits, exits),
        )
        val here = wearer?.let { resources.getString(R.string.map_wearer_in, wording.name(plan.rooms[it.room])) }
            ?: resources.getString(R.string.map_wearer_unknown)
        val way = wayM?.let { resources.getString(R.string.map_way, resources.roughLength(it, lengths)) }
        return listOfNotNull(
            resources.getString(R.string.map_sentence, title, level, size, here), way,
        ).joinToString(" ")
    }

    /** "Room 4, Seminar room. North of you, 12 feet. Door to Room 2. Exit: East stairs. Here: Lectern." */
    fun room(index: Int, wearer: Estimate?): String {
        val room = plan.rooms[index]
        return listOfNotNull(
            wording.room(room), lies(index, wearer), doors(index), exits(index), places(index),
        ).joinToString(" ")
    }

    private fun lies(index: Int, wearer: Estimate?): String? {
        if (wearer == null) return null
        if (wearer.room == index) return resources.getString(R.string.map_room_here)
        val own = plan.rooms[wearer.room]
        val room = plan.rooms[index]
        if (own.level != room.level) return null
        val from = own.frame.toLevel(Point(wearer.x, wearer.y))
        val to = room.middle()
        val eighth = (atan2(to.y - from.y, to.x - from.x) / (PI / 4)).roundToInt().mod(8)
        val compass = resources.getStringArray(R.array.compass)[eighth]
        return resources.getString(R.string.map_lies, compass, resources.roughLength(from.distanceTo(to), lengths))
    }

    private fun doors(index: Int): String {
        val others = plan.doors.mapNotNull { door ->
            when (index) {
                door.a.room -> door.b.room
                door.b.room -> door.a.room
                else -> null
            }
        }.distinct().map { wording.shortName(plan.rooms[it]) }
        return when (others.size) {
            0 -> resources.getString(R.string.map_no_doors)
            1 -> resources.getString(R.string.map_door_to, others.single())
            else -> resources.getString(R.string.map_doors_to, others.joinToString())
        }
    }

    private fun exits(index: Int): String? {
        val here = plan.exits.filter { it.spot.room == index }
        val names = here.map { it.name }.filter { it.isNotEmpty() }
        return when {
            here.isEmpty() -> null
            names.isEmpty() -> resources.getString(R.string.map_exit_unnamed)
            else -> resources.getString(R.string.map_exits, names.joinToString())
        }
    }

    private fun places(index: Int): String? {
        val names = plan.places.filter { it.spot.room == index }.map { it.name }
        return if (names.isEmpty()) null else resources.getString(R.string.map_places, names.joinToString())
    }
}

/** The middle of a room's box, in its level's frame. */
internal fun Room.middle(): Point {
    val corners = walls.flatMap { listOf(it.a, it.b) }.map(frame::toLevel)
    return Point(
        (corners.minOf { it.x } + corners.maxOf { it.x }) / 2, (corners.minOf { it.y } + corners.maxOf { it.y }) / 2,
    )
}
