package org.echoway.app.ui.belt

import androidx.compose.runtime.getValue
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import org.echoway.app.AppContainer
import org.echoway.app.settings.Settings
import org.echoway.app.ui.Route

/** The live belt view. */
fun NavGraphBuilder.beltView(container: AppContainer, back: () -> Unit) {
    composable<Route.BeltView> {
        val picture by container.navigator.picture.collectAsStateWithLifecycle()
        val settings by container.settings.settings.collectAsStateWithLifecycle(Settings())
        BeltScreen(picture.scan, settings.lengths, back)
    }
}
