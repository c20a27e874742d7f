package org.echoway.app.ui.here

import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.echoway.app.R
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.BigButton
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Subheading
import org.echoway.app.ui.destinations.DestinationGroup
import org.echoway.core.Destination

/** What the screen on which a wearer says where they stand shows. */
sealed interface HereUiState {
    /** Nobody is looked for while guidance is off. */
    data object Off : HereUiState

    data class Ready(val groups: List<DestinationGroup>) : HereUiState
}

/** What the wearer can do there: to stand at a place, or (null) not to know where. */
data class HereActions(val onStandAt: (Destination?) -> Unit, val onBack: () -> Unit)

/** For whoever is somewhere else than Echoway believes: entrances first, then rooms, under headings. */
@Composable
fun HereScreen(state: HereUiState, actions: HereActions) {
    Screen(stringResource(R.string.i_am_here), actions.onBack) {
        when (state) {
            HereUiState.Off -> Text(stringResource(R.string.here_off), style = MaterialTheme.typography.titleMedium)
            is HereUiState.Ready -> Ready(state, actions)
        }
    }
}

@Composable
private fun Ready(state: HereUiState.Ready, actions: HereActions) {
    Text(stringResource(R.string.here_hint), style = MaterialTheme.typography.titleMedium)
    BigButton(stringResource(R.string.here_unknown)) { actions.onStandAt(null) }
    state.groups.forEach { group ->
        Subheading(group.title)
        group.options.forEach { Action(it.title) { actions.onStandAt(it.destination) } }
    }
}
