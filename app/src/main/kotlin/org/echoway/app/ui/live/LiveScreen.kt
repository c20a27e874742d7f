package org.echoway.app.ui.live

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.material3.Button
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.ui.map.LevelMap

/** What the wearer can ask of the live screen. */
data class LiveActions(val onWhereAmI: () -> Unit, val onStart: () -> Unit, val onStop: () -> Unit, val onSetup: () -> Unit)

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
                LiveUiState.NeedsSetup -> Notice(stringResource(R.string.choose_building_first), R.string.setup, actions.onSetup)
                is LiveUiState.Failed -> Notice(stringResource(R.string.state_failed, state.reason), R.string.setup, actions.onSetup)
                is LiveUiState.Off -> Off(state, actions)
                is LiveUiState.On -> On(state, actions)
            }
        }
    }
}

@Composable
private fun ColumnScope.Notice(text: String, button: Int, onClick: () -> Unit) {
    Text(text, Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite }, style = MaterialTheme.typography.headlineSmall)
    BigButton(stringResource(button), onClick)
}

@Composable
private fun ColumnScope.Off(state: LiveUiState.Off, actions: LiveActions) {
    Title(state.building)
    val level = state.plan.rooms.first().level
    LevelMap(state.plan, level, null, stringResource(R.string.map_of, state.building), Modifier.weight(1f).fillMaxWidth())
    Text(stringResource(R.string.state_off), style = MaterialTheme.typography.titleMedium)
    BigButton(stringResource(R.string.start), actions.onStart)
    OutlinedButton(actions.onSetup, Modifier.fillMaxWidth().heightIn(min = MIN_TARGET)) { Text(stringResource(R.string.setup)) }
}

@Composable
private fun ColumnScope.On(state: LiveUiState.On, actions: LiveActions) {
    Title(state.building)
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
    BigButton(stringResource(R.string.where_am_i), actions.onWhereAmI)
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
        OutlinedButton(actions.onStop, Modifier.weight(1f).heightIn(min = MIN_TARGET)) { Text(stringResource(R.string.stop)) }
        OutlinedButton(actions.onSetup, Modifier.weight(1f).heightIn(min = MIN_TARGET)) { Text(stringResource(R.string.setup)) }
    }
}

@Composable
private fun Title(text: String) {
    Text(text, Modifier.semantics { heading() }, style = MaterialTheme.typography.titleLarge, textAlign = TextAlign.Center)
}

@Composable
private fun BigButton(text: String, onClick: () -> Unit) {
    Button(onClick, Modifier.fillMaxWidth().heightIn(min = BIG_TARGET)) {
        Text(text, style = MaterialTheme.typography.headlineMedium)
    }
}

private val MIN_TARGET = 48.dp
private val BIG_TARGET = 120.dp
