package org.echoway.app.guide

import org.echoway.app.engine.GuidanceEvent
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.core.Cue
import org.echoway.core.CueKind
import org.echoway.core.DestinationKind
import org.echoway.core.Plan
import org.echoway.core.TrackState

/**
 * Decides what the wearer is told as navigation goes on: of position and way what the core says, of belt and app what
 * happens to them. Silence means that all is well, so every loss of that is told.
 */
class Announcer {
    private val belt = BeltAnnouncer()
    private var previous: NavigationState = NavigationState.Idle

    /** What is new in a state, in the order in which it is to be said. */
    fun onState(state: NavigationState): List<Message> {
        val before = previous
        previous = state
        return when (state) {
            NavigationState.Idle -> emptyList<Message>().also { belt.reset() }
            is NavigationState.Failed -> if (before == state) emptyList() else listOf(Message.CannotStart(state.why))
            is NavigationState.Running -> {
                val played = before !is NavigationState.Running && !state.live
                listOfNotNull(Message.RecordedWalk.takeIf { played }) + belt.onState(state)
            }
        }
    }

    fun onEvent(event: GuidanceEvent): List<Message> = when (event) {
        is GuidanceEvent.Told ->
            if (event.cue.kind in OF_THE_BELT) {
                emptyList()
            } else {
                listOfNotNull(Message.Told(event.cue), detail(event.cue))
            }
        is GuidanceEvent.Granted -> confirmation(event.wish)
        is GuidanceEvent.Refused -> listOfNotNull(refusal(event.wish), barrier(event.wish))
        is GuidanceEvent.BeltChanged -> listOf(Message.BeltChanged(event.sensors))
        GuidanceEvent.WayBackLost -> listOf(Message.WayBackLost)
    }

    /** Whether the core can answer; otherwise what is said instead. */
    fun withoutAnswer(): NoAnswer? = when (val state = previous) {
        is NavigationState.Running -> when {
            state.hearsBelt -> null
            state.line.isForbidden -> NoAnswer.NotAllowed
            else -> NoAnswer.NoBelt(lastRoom(state))
        }
        else -> NoAnswer.NotRunning
    }

    /** The plan that the wearer walks through; null while guidance is off. */
    val plan: Plan? get() = previous.plan

    private fun lastRoom(state: NavigationState.Running) =
        state.building.plan.rooms.getOrNull(state.estimate.room).takeIf { state.estimate.state == TrackState.TRACKING }

    private fun detail(cue: Cue): Message? {
        val plan = plan
        if (cue.kind != CueKind.ENTERING || plan == null) return null
        val places = plan.places.filter { it.spot.room == cue.room && it.name.isNotEmpty() }.map { it.name }
        val doors = plan.doors.count { it.seenFrom(cue.room) != null }
        return Message.RoomDetail(doors, places).takeIf { doors > 0 || places.isNotEmpty() }
    }

    /** Of what the core answers by itself, nothing. Of a way that cannot be told just now, why. */
    private fun confirmation(wish: Wish): List<Message> = when (wish) {
        Wish.BackTrack -> listOfNotNull(Message.LeadingBack, withoutAnswer()?.let(Message::Unanswerable))
        Wish.StopLeading -> listOf(Message.LeadingStopped)
        is Wish.StandAt -> listOfNotNull(plan?.let { Message.StartedAgain(it, wish.place) })
        is Wish.LeadTo, Wish.WhereAmI, Wish.Repeat, Wish.AllowBelt -> emptyList()
    }

    private fun refusal(wish: Wish): Message? = when (wish) {
        is Wish.LeadTo -> Message.CannotLead(
            if (wish.destination.kind == DestinationKind.NEAREST_EXIT && plan?.exits.isNullOrEmpty()) {
                NoWay.NO_EXIT_KNOWN
            } else {
                NoWay.NOT_REACHABLE
            },
        )
        Wish.BackTrack -> Message.CannotLead(NoWay.NOTHING_WALKED_YET)
        Wish.Repeat -> Message.NothingToRepeat
        is Wish.StandAt -> plan?.let { Message.CannotStandAt(it, wish.place) }
        Wish.WhereAmI, Wish.StopLeading, Wish.AllowBelt -> null
    }

    /** Whoever has not walked yet because the belt may not be used is told that too. */
    private fun barrier(wish: Wish): Message? =
        Message.Unanswerable(NoAnswer.NotAllowed).takeIf {
            wish == Wish.BackTrack && withoutAnswer() == NoAnswer.NotAllowed
        }

    private companion object {
        /** The app watches the line itself: it knows of permissions and of recordings, and who is clear again. */
        val OF_THE_BELT = setOf(CueKind.BELT_LOST, CueKind.BELT_BACK, CueKind.BATTERY_LOW, CueKind.SENSOR_BLOCKED)
    }
}
