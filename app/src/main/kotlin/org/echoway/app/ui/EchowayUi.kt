package org.echoway.app.ui

import androidx.activity.compose.BackHandler
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.platform.LocalResources
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import org.echoway.app.AppContainer
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveViewModel
import org.echoway.app.ui.setup.SetupActions
import org.echoway.app.ui.setup.SetupScreen
import org.echoway.app.ui.setup.SetupViewModel

/** The app's screens. */
enum class Screen { LIVE, SETUP }

/** What only the activity can do. */
data class ActivityActions(val start: () -> Unit, val stop: () -> Unit, val pickRecording: () -> Unit)

/** View models are made and read here and nowhere below: screens get state and lambdas. */
@Composable
fun EchowayUi(container: AppContainer, setup: SetupViewModel, actions: ActivityActions) {
    var screen by rememberSaveable { mutableStateOf(Screen.LIVE) }
    val words = StateWords(LocalResources.current)
    val live = viewModel { LiveViewModel(container, words) }
    when (screen) {
        Screen.LIVE -> {
            val state by live.uiState.collectAsStateWithLifecycle()
            LiveScreen(state, LiveActions(live::whereAmI, actions.start, actions.stop) { screen = Screen.SETUP })
        }
        Screen.SETUP -> {
            val state by setup.uiState.collectAsStateWithLifecycle()
            BackHandler { screen = Screen.LIVE }
            SetupScreen(
                state,
                SetupActions(setup::chooseBuilding, setup::chooseEntrance, setup::chooseSource, actions.pickRecording) {
                    screen = Screen.LIVE
                },
            )
        }
    }
}
