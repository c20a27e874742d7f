package org.echoway.core

import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin

/** Metres. */
data class Point(val x: Double, val y: Double) {
    operator fun minus(other: Point) = Point(x - other.x, y - other.y)

    fun distanceTo(other: Point) = hypot(x - other.x, y - other.y)
}

data class Wall(val a: Point, val b: Point)

/** Takes a point from a room's frame into its level's frame; [heading] in radians. */
data class Frame(val x: Double, val y: Double, val heading: Double) {
    fun toLevel(p: Point): Point {
        val c = cos(heading)
        val s = sin(heading)
        return Point(x + c * p.x - s * p.y, y + s * p.x + c * p.y)
    }
}

/**
 * A room; coordinates are metres in its own frame.
 *
 * @property id as in the building's files
 * @property name what a wearer would call it; empty when the building does not say
 * @property aloud what the core calls it
 * @property boundary closed loops around the floor, first the outer one, then holes
 */
data class Room(
    val id: String,
    val name: String,
    val aloud: RoomName,
    val level: Int,
    val frame: Frame,
    val walls: List<Wall>,
    val boundary: List<List<Point>>,
)

/**
 * What a room is called aloud, whatever the language: "Room [number], [name]".
 * See `core-native/include/echoway/speech/room_name.hpp`.
 *
 * @property number empty for a room that is called by its name alone
 * @property name empty when the number says all
 */
data class RoomName(val number: String, val name: String)

/** A point in a room, by the room's index. */
data class Spot(val room: Int, val at: Point)

/** One opening, seen from the frames of both rooms; [width] in metres. */
data class Door(val a: Spot, val b: Spot, val width: Double) {
    /** This door as seen from a room, or null when it does not lead there. */
    fun seenFrom(room: Int): Point? = when (room) {
        a.room -> a.at
        b.room -> b.at
        else -> null
    }
}

enum class LevelLinkKind { STAIRS, ELEVATOR }

data class LevelLink(val kind: LevelLinkKind, val a: Spot, val b: Spot)

/** A destination or a way out. */
data class Landmark(val spot: Spot, val name: String)

/** A floor plan as the core understood it. */
data class Plan(
    val name: String,
    val rooms: List<Room>,
    val doors: List<Door>,
    val links: List<LevelLink>,
    val exits: List<Landmark>,
    val places: List<Landmark>,
) {
    companion object {
        const val NO_ROOM = -1
    }
}
