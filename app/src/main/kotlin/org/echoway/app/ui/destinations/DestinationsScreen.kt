package org.echoway.app.ui.destinations

import androidx.compose.foundation.layout.Column
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import org.echoway.app.R
import org.echoway.app.guide.Ask
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.BigButton
import org.echoway.app.ui.common.Choice
import org.echoway.app.ui.common.Choices
import org.echoway.app.ui.common.Screen
import org.echoway.core.Destination

/** What the wearer can do on the screen of destinations. */
data class DestinationsActions(val onLeadTo: (Destination) -> Unit, val onAsk: (Ask) -> Unit, val onBack: () -> Unit)

/**
 * Way out first, for whoever is in a hurry; then places, exits and rooms under headings that a screen
 * reader jumps between.
 */
@Composable
fun DestinationsScreen(state: DestinationsUiState, actions: DestinationsActions) {
    Screen(stringResource(R.string.where_to), actions.onBack) {
        when (state) {
            DestinationsUiState.Off ->
                Text(stringResource(R.string.leading_off), style = MaterialTheme.typography.titleMedium)
            is DestinationsUiState.Ready -> Ready(state, actions)
        }
    }
}

@Composable
private fun Ready(state: DestinationsUiState.Ready, actions: DestinationsActions) {
    val heard = if (state.answered) Modifier else Modifier.semantics { liveRegion = LiveRegionMode.Polite }
    Text(state.leading, heard, style = MaterialTheme.typography.titleMedium)
    BigButton(stringResource(R.string.way_out)) { actions.onAsk(Ask.WAY_OUT) }
    Action(stringResource(R.string.way_back)) { actions.onAsk(Ask.WAY_BACK) }
    Action(stringResource(R.string.stop_leading), enabled = state.led) { actions.onAsk(Ask.STOP_LEADING) }
    Column {
        state.groups.forEach { group ->
            Choices(group.title) {
                group.options.forEach { Choice(it.title, it.chosen) { actions.onLeadTo(it.destination) } }
            }
        }
    }
}
