package org.echoway.app.ui.destinations

import android.content.res.Resources
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
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
import org.echoway.app.ui.common.WHILE_SHOWN
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Plan

/** Choosing where to be led. */
class DestinationsViewModel(private val container: AppContainer, private val resources: Resources) : ViewModel() {
    private val wording = Wording(resources)
    private val lists = DestinationLists(resources)

    val uiState: StateFlow<DestinationsUiState> = container.navigator.state
        .map { state -> (state as? NavigationState.Running)?.let { it.building.plan to it.leading } }
        .distinctUntilChanged()
        .map { it?.let { (plan, leading) -> show(plan, leading) } ?: DestinationsUiState.Off }
        .stateIn(viewModelScope, WHILE_SHOWN, DestinationsUiState.Off)

    fun leadTo(destination: Destination) = container.guide.leadTo(destination)

    fun ask(ask: Ask) = container.guide.ask(ask)

    private fun show(plan: Plan, leading: Wish?) = DestinationsUiState.Ready(
        leading = when (leading) {
            is Wish.LeadTo -> resources.getString(R.string.leading_to, wording.name(plan, leading.destination))
            Wish.BackTrack -> resources.getString(R.string.leading_back)
            else -> resources.getString(R.string.leading_nowhere)
        },
        led = leading != null,
        // Of a destination the core speaks once it knows where the wearer is.
        answered = leading !is Wish.LeadTo,
        groups = lists.groups(plan, KINDS, (leading as? Wish.LeadTo)?.destination),
    )

    private companion object {
        val KINDS = listOf(DestinationKind.PLACE, DestinationKind.EXIT, DestinationKind.ROOM)
    }
}
