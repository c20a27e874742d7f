package org.echoway.app.ui.destinations

import android.content.res.Resources
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.flow.SharingStarted
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.stateIn
import org.echoway.app.AppContainer
import org.echoway.app.R
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.app.guide.Ask
import org.echoway.app.guide.Wording
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Plan
import org.echoway.core.destinations

/** Choosing where to be led. */
class DestinationsViewModel(private val container: AppContainer, private val resources: Resources) : ViewModel() {
    private val wording = Wording(resources)

    val uiState: StateFlow<DestinationsUiState> = container.navigator.state
        .map { state -> (state as? NavigationState.Running)?.let { it.building.plan to it.leading } }
        .distinctUntilChanged()
        .map { it?.let { (plan, leading) -> show(plan, leading) } ?: DestinationsUiState.Off }
        .stateIn(viewModelScope, SharingStarted.WhileSubscribed(STOP_AFTER_MS), DestinationsUiState.Off)

    fun leadTo(destination: Destination) = container.guide.leadTo(destination)

    fun ask(ask: Ask) = container.guide.ask(ask)

    private fun show(plan: Plan, leading: Wish?) = DestinationsUiState.Ready(
        leading = when (leading) {
            is Wish.LeadTo -> resources.getString(R.string.leading_to, wording.name(plan, leading.destination))
            Wish.BackTrack -> resources.getString(R.string.leading_back)
            else -> resources.getString(R.string.leading_nowhere)
        },
        led = leading != null,
        groups = GROUPS.map { (kind, title) -> group(plan, kind, resources.getString(title), (leading as? Wish.LeadTo)?.destination) }
            .filter { it.options.isNotEmpty() },
    )

    private fun group(plan: Plan, kind: DestinationKind, title: String, chosen: Destination?): DestinationGroup {
        val levels = plan.rooms.map { it.level }.distinct().size > 1
        val options = plan.destinations.filter { it.kind == kind && plan.isNamed(it) }
            .map { DestinationOption(it, title(plan, it, levels), it == chosen) }
        return DestinationGroup(title, options.sortedWith(compareBy(NATURAL) { it.title }))
    }

    /** Enough to tell it from its namesakes, and nothing that is the same for all. */
    private fun title(plan: Plan, destination: Destination, levels: Boolean): String {
        val name = wording.name(plan, destination)
        val room = plan.rooms[plan.roomOf(destination)]
        return when {
            destination.kind != DestinationKind.ROOM -> resources.getString(R.string.place_in_room, name, wording.name(room))
            levels -> resources.getString(R.string.room_on_level, name, room.level)
            else -> name
        }
    }

    private fun Plan.isNamed(destination: Destination) = destination.kind != DestinationKind.PLACE || places[destination.index].name.isNotEmpty()

    private fun Plan.roomOf(destination: Destination) = when (destination.kind) {
        DestinationKind.PLACE -> places[destination.index].spot.room
        DestinationKind.EXIT -> exits[destination.index].spot.room
        else -> destination.index
    }

    private companion object {
        const val STOP_AFTER_MS = 5_000L
        val GROUPS = listOf(DestinationKind.PLACE to R.string.places, DestinationKind.EXIT to R.string.exits, DestinationKind.ROOM to R.string.rooms)
        private const val WIDTH = 8

        /** Room 10 after room 9. */
        val NATURAL = Comparator<String> { a, b -> padded(a).compareTo(padded(b), ignoreCase = true) }

        private fun padded(text: String) = text.replace(Regex("\\d+")) { it.value.padStart(WIDTH, '0') }
    }
}
