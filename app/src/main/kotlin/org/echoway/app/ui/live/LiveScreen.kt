package org.echoway.app.ui.live

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.BigButton
import org.echoway.app.ui.common.Heading
import org.echoway.app.ui.map.LevelMap

/** What the wearer can ask of the live screen. */
data class LiveActions(
    val onWhereAmI: () -> Unit,
    val onStart: () -> Unit,
    val onStop: () -> Unit,
    val onSetup: () -> Unit,
    val onMenu: () -> Unit,
)

/** Map, state in words, and a button that can be found without looking. */
@Composable
fun LiveScreen(state: LiveUiState, actions: LiveActions) {
    Surface(Modifier.fillMaxSize()) {
        Column(
            Modifier.safeDrawingPadding().padding(16.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
            horizontalAlignment = Alignment.CenterHorizontally,
        ) {
            when (state) {
                LiveUiState.Loading -> Unit
                LiveUiState.NeedsSetup -> Notice(stringResource(R.string.choose_building_first), actions)
                is LiveUiState.Failed -> Notice(stringResource(R.string.state_failed, state.reason), actions)
                is LiveUiState.Off -> Off(state, actions)
                is LiveUiState.On -> On(state, actions)
            }
        }
    }
}

@Composable
private fun ColumnScope.Notice(text: String, actions: LiveActions) {
    Heading(text, Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite })
    BigButton(stringResource(R.string.setup), onClick = actions.onSetup)
    Action(stringResource(R.string.menu), onClick = actions.onMenu)
}

@Composable
private fun ColumnScope.Off(state: LiveUiState.Off, actions: LiveActions) {
    Heading(state.building)
    val level = state.plan.rooms.first().level
    LevelMap(state.plan, level, null, stringResource(R.string.map_of, state.building), Modifier.weight(1f).fillMaxWidth())
    Text(stringResource(R.string.state_off), style = MaterialTheme.typography.titleMedium)
    BigButton(stringResource(R.string.start), onClick = actions.onStart)
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
        Action(stringResource(R.string.setup), Modifier.weight(1f), onClick = actions.onSetup)
        Action(stringResource(R.string.menu), Modifier.weight(1f), onClick = actions.onMenu)
    }
}

@Composable
private fun ColumnScope.On(state: LiveUiState.On, actions: LiveActions) {
    Heading(state.building)
    val description = stringResource(R.string.map_with_wearer, state.building, state.words)
    LevelMap(state.plan, state.level, state.wearer, description, Modifier.weight(1f).fillMaxWidth())
    // The voice says this already; TalkBack reads it on demand instead of talking over the guidance.
    Text(state.words, style = MaterialTheme.typography.headlineSmall, textAlign = TextAlign.Center)
    if (state.lastLine.isNotEmpty() && state.lastLine != state.words) {
        Text(state.lastLine, style = MaterialTheme.typography.bodyLarge, textAlign = TextAlign.Center)
    }
    if (state.voiceMissing) {
        Text(stringResource(R.string.voice_missing), color = MaterialTheme.colorScheme.error, textAlign = TextAlign.Center)
    }
    BigButton(stringResource(R.string.where_am_i), onClick = actions.onWhereAmI)
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
        Action(stringResource(R.string.stop), Modifier.weight(1f), onClick = actions.onStop)
        Action(stringResource(R.string.menu), Modifier.weight(1f), onClick = actions.onMenu)
    }
}
