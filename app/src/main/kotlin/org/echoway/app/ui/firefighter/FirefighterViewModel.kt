package org.echoway.app.ui.firefighter

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.stateIn
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.echoway.app.AppContainer
import org.echoway.app.control.Stillness
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Ask
import org.echoway.app.ui.StateWords
import org.echoway.app.ui.common.WHILE_SHOWN
import org.echoway.app.voice.VoiceStatus

/** Firefighter mode: on until its screen is left, through restarts of the app too. */
class FirefighterViewModel(private val container: AppContainer, private val words: StateWords) : ViewModel() {
    val uiState: StateFlow<FirefighterUiState> =
        combine(
            container.navigator.state, container.guide.lastLine, container.lookout.stillness, container.voice.status,
        ) { state, line, stillness, voice ->
            FirefighterUiState(
                words.of(state), line, state is NavigationState.Running, stillness, voice == VoiceStatus.NO_ENGINE,
            )
        }.stateIn(viewModelScope, WHILE_SHOWN, FirefighterUiState("", "", running = false, Stillness.MOVING))

    fun ask(ask: Ask) = container.guide.ask(ask)

    fun cancelAlarm() = container.lookout.cancel()

    fun enter() = choose(true)

    fun leave() = choose(false)

    private fun choose(on: Boolean) {
        // The screen is gone before a phone that is busy has written this down; the mode must not stay on without it.
        viewModelScope.launch {
            withContext(NonCancellable) { container.settings.update { it.copy(firefighter = on) } }
        }
    }
}
