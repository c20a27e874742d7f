package org.echoway.app.guide

import org.echoway.app.engine.NavigationState
import org.echoway.core.Estimate
import org.echoway.core.Plan
import org.echoway.core.TrackState

/** Tells of the wearer's way: rooms entered, doors and places near, position lost and found again. */
internal class PositionAnnouncer {
    private enum class Knowledge { NONE_YET, SURE, UNSURE }

    private var knowledge = Knowledge.NONE_YET
    private val sureRoom = Settled<Int?>(null, ROOM_SETTLES_S)
    private var room: Int? = null
    private var toldSearching = false
    private val near = mutableSetOf<Any>()

    fun onState(state: NavigationState.Running): List<Message> {
        if (!state.hearsBelt) return emptyList()
        val plan = state.building.plan
        val estimate = state.estimate
        val tracking = estimate.state == TrackState.TRACKING && estimate.room in plan.rooms.indices
        val settled = sureRoom.update(if (tracking) estimate.room else null, state.timeS)
        return when {
            settled != null && knowledge != Knowledge.SURE -> found(plan, estimate, settled)
            settled != null && settled != room -> listOf(enter(plan, estimate, settled))
            settled != null && estimate.room == settled -> nearMessages(plan, estimate)
            settled == null -> notKnown()
            else -> emptyList()
        }
    }

    private fun found(plan: Plan, estimate: Estimate, settled: Int): List<Message> {
        val first = knowledge == Knowledge.NONE_YET
        knowledge = Knowledge.SURE
        val entered = enter(plan, estimate, settled)
        if (first) return listOf(entered)
        val door = Surroundings(plan, estimate).doors.firstOrNull()?.second?.direction
        return listOf(Message.FoundAgain(plan.rooms[settled], door))
    }

    private fun notKnown(): List<Message> {
        if (knowledge == Knowledge.SURE) {
            knowledge = Knowledge.UNSURE
            return listOf(Message.Unsure)
        }
        if (knowledge == Knowledge.UNSURE || toldSearching) return emptyList()
        toldSearching = true
        return listOf(Message.Searching)
    }

    private fun enter(plan: Plan, estimate: Estimate, entered: Int): Message {
        room = entered
        near.clear()
        // The door that one came through is not news.
        if (estimate.room == entered) {
            Surroundings(plan, estimate).doors.filter { it.second.distanceM < JUST_PASSED_M }.forEach { near += it.first }
        }
        return Message.RoomEntered(plan.rooms[entered])
    }

    private fun nearMessages(plan: Plan, estimate: Estimate): List<Message> {
        val around = Surroundings(plan, estimate)
        val messages = mutableListOf<Message>()
        for ((door, seen) in around.doors) if (becameNear(door, seen)) messages += Message.DoorNear(seen)
        for (place in around.places) if (becameNear(place.name, place.seen)) messages += Message.PlaceNear(place.name, place.seen)
        return messages
    }

    /** Once an approach: not again before the wearer has gone away from it. */
    private fun becameNear(what: Any, seen: Seen): Boolean {
        if (seen.distanceM > AWAY_M) near -= what
        val behind = seen.direction == Direction.BEHIND || seen.direction == Direction.SHARP_LEFT || seen.direction == Direction.SHARP_RIGHT
        return seen.distanceM < NEAR_M && !behind && near.add(what)
    }

    private companion object {
        /** An estimate that wavers at a doorway is not worth a word each time. */
        const val ROOM_SETTLES_S = 0.7
        const val NEAR_M = 2.4
        const val AWAY_M = 3.6
        const val JUST_PASSED_M = 1.5
    }
}

/** A value that counts only once it has been the same for a while. */
internal class Settled<T>(initial: T, private val afterS: Double) {
    private var settled = initial
    private var candidate = initial
    private var sinceS = Double.NEGATIVE_INFINITY

    fun update(value: T, nowS: Double): T {
        if (value != candidate) {
            candidate = value
            sinceS = nowS
        }
        if (nowS - sinceS >= afterS) settled = candidate
        return settled
    }
}
