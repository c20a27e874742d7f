package org.echoway.app.ui.live

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.mapLatest
import kotlinx.coroutines.flow.stateIn
import org.echoway.app.AppContainer
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Ask
import org.echoway.app.ui.StateWords
import org.echoway.app.ui.common.WHILE_SHOWN
import org.echoway.app.voice.VoiceStatus
import org.echoway.core.LengthStyle
import org.echoway.core.Plan

/** Turns navigation into what the live screen shows. */
class LiveViewModel(private val container: AppContainer, private val words: StateWords) : ViewModel() {
    @OptIn(ExperimentalCoroutinesApi::class)
    private val chosen: Flow<Choice> = container.settings.settings
        .map { it.building }
        .distinctUntilChanged()
        .mapLatest { id -> id?.let { container.buildings.find(it) }?.let(Choice::Building) ?: Choice.Nothing }

    private var level: Int? = null

    val uiState: StateFlow<LiveUiState> =
        combine(chosen, container.navigator.state, container.guide.lastLine, container.voice.status, ::show)
            .combine(container.navigator.picture) { state, picture ->
                if (state is LiveUiState.On) state.copy(picture = picture) else state
            }
            .combine(container.settings.settings.map { it.lengths }.distinctUntilChanged(), ::measured)
            .stateIn(viewModelScope, WHILE_SHOWN, LiveUiState.Loading)

    fun whereAmI() = container.guide.ask(Ask.WHERE_AM_I)

    private fun show(
        chosen: Choice,
        state: NavigationState,
        lastLine: String,
        voice: VoiceStatus,
    ): LiveUiState = when (state) {
        is NavigationState.Running -> on(state, lastLine, voice)
        is NavigationState.Failed -> LiveUiState.Failed(words.of(state), state.reason)
        NavigationState.Idle -> when (chosen) {
            is Choice.Building ->
                LiveUiState.Off(chosen.building.title, chosen.building.plan, voice == VoiceStatus.NO_ENGINE)
            Choice.Nothing -> LiveUiState.NeedsSetup
        }
    }

    private fun measured(state: LiveUiState, lengths: LengthStyle) = when (state) {
        is LiveUiState.On -> state.copy(lengths = lengths)
        is LiveUiState.Off -> state.copy(lengths = lengths)
        else -> state
    }

    private fun on(state: NavigationState.Running, lastLine: String, voice: VoiceStatus): LiveUiState.On {
        val plan = state.building.plan
        val wearer = state.estimate.takeIf { it.room != Plan.NO_ROOM && it.room in plan.rooms.indices }
        wearer?.let { level = plan.rooms[it.room].level }
        return LiveUiState.On(
            building = state.building.title,
            plan = plan,
            words = words.of(state),
            lastLine = lastLine,
            wearer = wearer,
            level = level ?: plan.rooms.first().level,
            voiceMissing = voice == VoiceStatus.NO_ENGINE,
        )
    }

    private sealed interface Choice {
        data object Nothing : Choice

        data class Building(val building: InstalledBuilding) : Choice
    }
}
