package org.echoway.app.guide

import org.echoway.app.engine.NavigationState
import org.echoway.core.Plan
import org.echoway.core.TrackState

/** Decides what the wearer is told as navigation goes on. Silence means that all is well, so every loss of that is told. */
class Announcer {
    private val belt = BeltAnnouncer()
    private var position = PositionAnnouncer()
    private var previous: NavigationState = NavigationState.Idle

    /** What is new in a state, in the order in which it is to be said. */
    fun onState(state: NavigationState): List<Message> {
        val before = previous
        previous = state
        return when (state) {
            NavigationState.Idle -> emptyList<Message>().also { reset() }
            is NavigationState.Failed -> if (before == state) emptyList() else listOf(Message.CannotStart(state.reason))
            is NavigationState.Running -> belt.onState(state) + position.onState(state)
        }
    }

    /** The answer to "Where am I?". */
    fun whereAmI(): Message.WhereAmI = Message.WhereAmI(answer(previous))

    private fun reset() {
        belt.reset()
        position = PositionAnnouncer()
    }

    private fun answer(state: NavigationState): Answer {
        if (state !is NavigationState.Running) return Answer.NotRunning
        val rooms = state.building.plan.rooms
        val estimate = state.estimate
        val room = rooms.getOrNull(estimate.room)
        return when {
            !state.hearsBelt -> Answer.NoBelt(room.takeIf { estimate.state == TrackState.TRACKING })
            room == null || estimate.room == Plan.NO_ROOM -> Answer.Unsure(null)
            estimate.state == TrackState.TRACKING -> Surroundings(state.building.plan, estimate).answer()
            else -> Answer.Unsure(room.takeIf { estimate.state == TrackState.SEARCHING && estimate.roomProbability > LIKELY })
        }
    }

    private companion object {
        const val LIKELY = 0.5
    }
}
