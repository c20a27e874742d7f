package org.echoway.app.ui.here

import android.content.res.Resources
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.stateIn
import org.echoway.app.AppContainer
import org.echoway.app.ui.common.WHILE_SHOWN
import org.echoway.app.ui.destinations.DestinationLists
import org.echoway.core.Destination
import org.echoway.core.DestinationKind

/** Saying where one stands. */
class HereViewModel(private val container: AppContainer, resources: Resources) : ViewModel() {
    private val lists = DestinationLists(resources)

    val uiState: StateFlow<HereUiState> = container.navigator.state
        .map { it.plan }
        .distinctUntilChanged()
        .map { plan -> plan?.let { HereUiState.Ready(lists.groups(it, KINDS)) } ?: HereUiState.Off }
        .stateIn(viewModelScope, WHILE_SHOWN, HereUiState.Off)

    fun standAt(place: Destination?) = container.guide.standAt(place)

    private companion object {
        val KINDS = listOf(DestinationKind.EXIT, DestinationKind.ROOM)
    }
}
