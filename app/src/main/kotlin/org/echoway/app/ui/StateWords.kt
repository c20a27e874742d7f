package org.echoway.app.ui

import android.content.res.Resources
import org.echoway.app.R
import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Wording
import org.echoway.app.guide.hearsBelt
import org.echoway.core.BeltLink
import org.echoway.core.TrackState

/** The state of navigation in a few words, for screen and notification. */
class StateWords(private val resources: Resources) {
    private val wording = Wording(resources)

    fun of(state: NavigationState): String = when (state) {
        NavigationState.Idle -> resources.getString(R.string.state_off)
        is NavigationState.Failed -> wording.cannotStart(state.why)
        is NavigationState.Running -> running(state)
    }

    private fun running(state: NavigationState.Running): String {
        val room = state.building.plan.rooms.getOrNull(state.estimate.room)
        return when {
            state.line == Line.PERMISSION_MISSING -> resources.getString(R.string.state_permission)
            state.line == Line.REFUSED -> resources.getString(R.string.say_belt_refused)
            state.line == Line.ENDED -> resources.getString(R.string.state_ended)
            !state.hearsBelt && (state.belt.link == BeltLink.LOST || state.line == Line.GONE) ->
                resources.getString(R.string.state_belt_lost)
            !state.hearsBelt -> resources.getString(R.string.state_waiting)
            state.estimate.state == TrackState.LOST -> resources.getString(R.string.state_lost)
            state.estimate.state == TrackState.SEARCHING || room == null ->
                resources.getString(R.string.state_searching)
            else -> wording.room(room)
        }
    }
}
