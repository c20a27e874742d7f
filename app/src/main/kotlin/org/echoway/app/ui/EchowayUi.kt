package org.echoway.app.ui

import androidx.compose.animation.EnterTransition
import androidx.compose.animation.ExitTransition
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.platform.LocalContext
import androidx.compose.ui.platform.LocalResources
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import androidx.navigation.NavGraphBuilder
import androidx.navigation.NavHostController
import androidx.navigation.compose.NavHost
import androidx.navigation.compose.composable
import androidx.navigation.compose.rememberNavController
import org.echoway.app.AppContainer
import org.echoway.app.settings.inLanguage
import org.echoway.app.ui.belt.beltView
import org.echoway.app.ui.buildings.buildings
import org.echoway.app.ui.diagnostics.diagnostics
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveViewModel
import org.echoway.app.ui.menu.MenuScreen
import org.echoway.app.ui.recordings.recordings
import org.echoway.app.ui.settings.SettingsScreen
import org.echoway.app.ui.settings.SettingsViewModel
import org.echoway.app.ui.setup.SetupActions
import org.echoway.app.ui.setup.SetupScreen
import org.echoway.app.ui.setup.SetupViewModel
import org.echoway.core.Language

/** What only the activity can do. */
data class ActivityActions(val start: () -> Unit, val stop: () -> Unit, val pickRecording: () -> Unit)

/** View models are made and read here and nowhere below: screens get state and lambdas. */
@Composable
fun EchowayUi(container: AppContainer, setup: SetupViewModel, actions: ActivityActions) {
    val model = viewModel { SettingsViewModel(container.settings) }
    val settings by model.settings.collectAsStateWithLifecycle()
    // Nothing is drawn before the language and the colours are known: a flash of light hurts in the dark.
    val chosen = settings ?: return
    InLanguage(chosen.language) {
        EchowayTheme(chosen.theme) {
            val screens = rememberNavController()
            val open: (Route) -> Unit = { route -> screens.navigate(route) { launchSingleTop = true } }
            val home: () -> Unit = { screens.navigate(Route.Live) { popUpTo(screens.graph.id) { inclusive = true } } }
            val first = remember { firstScreen(chosen) }
            NavHost(
                screens,
                startDestination = first,
                // A screen that slides is a screen that TalkBack reads twice.
                enterTransition = { EnterTransition.None },
                exitTransition = { ExitTransition.None },
            ) {
                guidance(container, actions, open)
                composable<Route.Menu> { MenuScreen(open, screens::back) }
                wearerScreens(container, actions, home, screens::back) {
                    if (screens.previousBackStackEntry != null) screens.popBackStack() else home()
                }
                setup(setup, actions, screens::back)
                buildings(container, open, screens::back)
                recordings(container, actions.start, open, screens::back)
                diagnostics(container, screens::back)
                beltView(container, screens::back)
                composable<Route.Settings> { SettingsScreen(chosen, model::change, screens::back) }
            }
        }
    }
}

/** Leaves the first screen alone: there is nothing behind it. */
private fun NavHostController.back() {
    if (previousBackStackEntry != null) popBackStack()
}

private fun NavGraphBuilder.guidance(container: AppContainer, actions: ActivityActions, open: (Route) -> Unit) {
    composable<Route.Live> {
        val words = StateWords(LocalResources.current)
        val live =
            viewModel(key = LocalConfiguration.current.locales.toLanguageTags()) { LiveViewModel(container, words) }
        val state by live.uiState.collectAsStateWithLifecycle()
        LiveScreen(
            state, LiveActions(live::whereAmI, actions.start, actions.stop, { open(Route.Setup) }) { open(Route.Menu) },
        )
    }
}

private fun NavGraphBuilder.setup(setup: SetupViewModel, actions: ActivityActions, back: () -> Unit) {
    composable<Route.Setup> {
        val state by setup.uiState.collectAsStateWithLifecycle()
        SetupScreen(
            state,
            SetupActions(
                setup::chooseBuilding, setup::chooseEntrance, setup::chooseSource, actions.pickRecording, back,
            ),
        )
    }
}

/** Everything inside reads its words in the chosen language. */
@Composable
private fun InLanguage(language: Language?, content: @Composable () -> Unit) {
    val base = LocalContext.current
    val configuration = LocalConfiguration.current
    val context = remember(base, configuration, language) { base.inLanguage(language) }
    // Always provided, the phone's own too: a change of language must not begin the screens anew.
    CompositionLocalProvider(
        LocalConfiguration provides context.resources.configuration,
        LocalResources provides context.resources,
        content = content,
    )
}
