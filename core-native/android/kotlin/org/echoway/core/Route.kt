package org.echoway.core

import java.nio.ByteBuffer

/** What can be gone to; ordinals as in the core's goals. */
enum class DestinationKind {
    /** Any spot; never asked for by the app. */
    SPOT,
    PLACE,
    EXIT,
    NEAREST_EXIT,
    ROOM,
}

/** Somewhere to go: a place, an exit or a room by its index in the [Plan], or the nearest way out. */
data class Destination(val kind: DestinationKind, val index: Int = -1) {
    companion object {
        val WAY_OUT = Destination(DestinationKind.NEAREST_EXIT)
    }
}

/** Everywhere that one can ask to be led: places, then exits, then rooms. */
val Plan.destinations: List<Destination>
    get() = places.indices.map { Destination(DestinationKind.PLACE, it) } +
        exits.indices.map { Destination(DestinationKind.EXIT, it) } +
        rooms.indices.map { Destination(DestinationKind.ROOM, it) }

/** What the wearer wants of a way. */
data class RoutePreferences(val avoidStairs: Boolean = false)

/** What a point of a way is; ordinals as in the core. */
enum class WaypointKind { START, TURN, DOOR, LINK_FROM, LINK_TO, GOAL }

/**
 * A point of a way.
 *
 * @property index of the door or level link that it is
 * @property next doors only: the same point as a spot of the room that is entered
 */
data class Waypoint(val spot: Spot, val kind: WaypointKind, val index: Int, val next: Spot?)

/**
 * The way to the destination, straight in between waypoints; empty without one. At a door the next waypoint is in the
 * next room's frame.
 *
 * @property lengthM walked, stairs counted with what they cost
 * @property clearanceM the least that it keeps from walls, doorways apart; infinite for an empty way
 * @property goal what it leads to: for the nearest exit the exit that was chosen
 */
data class Route(
    val waypoints: List<Waypoint>,
    val lengthM: Double,
    val clearanceM: Double,
    val usesStairs: Boolean,
    val usesElevator: Boolean,
    val goal: Destination,
) {
    companion object {
        val NONE = Route(
            emptyList(),
            0.0,
            Double.POSITIVE_INFINITY,
            usesStairs = false,
            usesElevator = false,
            Destination(DestinationKind.SPOT),
        )
    }
}

/** One of several places that explain the echoes. [x], [y] in the room's frame, metres; [heading] in radians. */
data class Hypothesis(
    val room: Int,
    val x: Double,
    val y: Double,
    val heading: Double,
    val sigmaM: Double,
    val probability: Double,
)

/** What a reading came from; ordinals as in the core. */
enum class Element { NONE, WALL, CORNER, EDGE, REFLECTOR }

/**
 * The newest reading of a sensor, and what in the plan explains it.
 *
 * @property timeS negative before the sensor's first firing
 * @property rangeM from the transducer's face; null when nothing answered
 * @property element [Element.NONE] when nothing mapped agrees with the reading
 * @property at where the sound turned back, with the room in whose frame it is; null without an [element]
 * @property expectedM what the range should be by the plan; null without an [element]
 */
data class ExplainedEcho(
    val timeS: Double,
    val rangeM: Double?,
    val element: Element,
    val at: Spot?,
    val expectedM: Double?,
)

/** Reads what a picture of the session needs; see `core-native/jni/layouts.hpp`. */
internal object PictureLayout {
    fun route(from: ByteBuffer): Route {
        val length = from.getDouble()
        val clearance = from.getDouble()
        val stairs = from.flag()
        val elevator = from.flag()
        val goal = Destination(DestinationKind.entries[from.getInt()], from.getInt())
        return Route(from.list(::waypoint), length, clearance, stairs, elevator, goal)
    }

    fun spots(from: ByteBuffer): List<Spot> = from.list(::spot)

    fun hypotheses(from: ByteBuffer): List<Hypothesis> = from.list {
        Hypothesis(it.getInt(), it.getDouble(), it.getDouble(), it.getDouble(), it.getDouble(), it.getDouble())
    }

    fun echoes(from: ByteBuffer): List<ExplainedEcho> = from.list(::echo)

    private fun spot(from: ByteBuffer) = Spot(from.getInt(), from.point())

    private fun waypoint(from: ByteBuffer): Waypoint {
        val here = spot(from)
        val kind = WaypointKind.entries[from.getInt()]
        val index = from.getInt()
        val next = spot(from)
        return Waypoint(here, kind, index, next.takeIf { kind == WaypointKind.DOOR })
    }

    private fun echo(from: ByteBuffer): ExplainedEcho {
        val time = from.getDouble()
        val range = from.getDouble().takeIf { it >= 0.0 }
        val element = Element.entries[from.getInt()]
        val at = spot(from)
        val expected = from.getDouble()
        val known = element != Element.NONE
        return ExplainedEcho(time, range, element, at.takeIf { known }, expected.takeIf { known })
    }
}
