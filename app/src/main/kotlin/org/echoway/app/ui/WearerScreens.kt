package org.echoway.app.ui

import android.content.Context
import android.view.accessibility.AccessibilityManager
import androidx.activity.compose.BackHandler
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.platform.LocalContext
import androidx.compose.ui.platform.LocalResources
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import org.echoway.app.AppContainer
import org.echoway.app.settings.Settings
import org.echoway.app.ui.destinations.DestinationsActions
import org.echoway.app.ui.destinations.DestinationsScreen
import org.echoway.app.ui.destinations.DestinationsViewModel
import org.echoway.app.ui.firefighter.FirefighterActions
import org.echoway.app.ui.firefighter.FirefighterScreen
import org.echoway.app.ui.firefighter.FirefighterViewModel
import org.echoway.app.ui.firstrun.FirstRunActions
import org.echoway.app.ui.firstrun.FirstRunScreen
import org.echoway.app.ui.firstrun.FirstRunViewModel
import org.echoway.app.ui.here.HereActions
import org.echoway.app.ui.here.HereScreen
import org.echoway.app.ui.here.HereViewModel
import org.echoway.app.ui.practice.PracticeScreen

/** What is shown first: the introduction once, and firefighter mode until it is left. */
internal fun firstScreen(settings: Settings): Route = when {
    settings.firefighter -> Route.Firefighter
    !settings.introduced -> Route.FirstRun
    else -> Route.Live
}

/**
 * The screens of voice, touch and controls.
 *
 * @param home shows the live screen and forgets the way there
 * @param leave goes back, or home from the first screen
 */
internal fun NavGraphBuilder.wearerScreens(
    container: AppContainer,
    actions: ActivityActions,
    home: () -> Unit,
    back: () -> Unit,
    leave: () -> Unit,
) {
    composable<Route.Destinations> {
        val resources = LocalResources.current
        val model = viewModel(key = LocalConfiguration.current.locales.toLanguageTags()) {
            DestinationsViewModel(container, resources)
        }
        val state by model.uiState.collectAsStateWithLifecycle()
        DestinationsScreen(state, DestinationsActions(model::leadTo, model::ask, back))
    }
    composable<Route.Here> {
        val resources = LocalResources.current
        val model =
            viewModel(key = LocalConfiguration.current.locales.toLanguageTags()) { HereViewModel(container, resources) }
        val state by model.uiState.collectAsStateWithLifecycle()
        HereScreen(state, HereActions(model::standAt, back))
    }
    composable<Route.Practice> { PracticeScreen(container.buzzer.present, container.guide::practise, back) }
    firefighter(container, actions, leave)
    firstRun(container, actions, home)
}

private fun NavGraphBuilder.firefighter(container: AppContainer, actions: ActivityActions, leave: () -> Unit) {
    composable<Route.Firefighter> {
        val words = StateWords(LocalResources.current)
        val model = viewModel(key = LocalConfiguration.current.locales.toLanguageTags()) {
            FirefighterViewModel(container, words)
        }
        val state by model.uiState.collectAsStateWithLifecycle()
        LaunchedEffect(model) { model.enter() }
        val end = {
            model.leave()
            leave()
        }
        // Out of sight the mode must not stay on: its keys and its alarm would surprise.
        BackHandler(onBack = end)
        FirefighterScreen(state, FirefighterActions(model::ask, actions.start, model::cancelAlarm, end))
    }
}

/** What TalkBack needs to say which screen this is. */
private fun readerFirstMs(context: Context): Long {
    val touchExploration = context.getSystemService(AccessibilityManager::class.java).isTouchExplorationEnabled
    return if (touchExploration) READER_FIRST_MS else 0L
}

private const val READER_FIRST_MS = 2500L

private fun NavGraphBuilder.firstRun(container: AppContainer, actions: ActivityActions, home: () -> Unit) {
    composable<Route.FirstRun> {
        val resources = LocalResources.current
        val context = LocalContext.current
        val model = viewModel { FirstRunViewModel(container, resources, readerFirstMs(context)) }
        val step by model.step.collectAsStateWithLifecycle()
        val practise = {
            actions.start()
            home()
        }
        FirstRunScreen(
            step,
            FirstRunActions(model::next, model::back, model::again, { model.skip(home) }) { model.practise(practise) },
        )
    }
}
