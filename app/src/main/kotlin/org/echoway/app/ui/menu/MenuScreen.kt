package org.echoway.app.ui.menu

import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.echoway.app.R
import org.echoway.app.ui.Route
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.Screen

/** Where the menu leads, in its order. */
private val ENTRIES = listOf(
    R.string.where_to to Route.Destinations,
    R.string.i_am_here to Route.Here,
    R.string.setup to Route.Setup,
    R.string.buildings to Route.Buildings,
    R.string.belt_view to Route.BeltView,
    R.string.diagnostics to Route.Diagnostics,
    R.string.recordings to Route.Recordings,
    R.string.settings to Route.Settings,
    R.string.practice to Route.Practice,
    R.string.firefighter to Route.Firefighter,
    R.string.introduction to Route.FirstRun,
)

/** The way to every other screen. */
@Composable
fun MenuScreen(onOpen: (Route) -> Unit, onBack: () -> Unit) {
    Screen(stringResource(R.string.menu), onBack) {
        ENTRIES.forEach { (title, route) -> Action(stringResource(title)) { onOpen(route) } }
    }
}
