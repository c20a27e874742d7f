package org.echoway.app.ui.setup

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Button
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.RadioButton
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.settings.SourceKind

/** What the wearer can do on the setup screen. */
data class SetupActions(
    val onBuilding: (String) -> Unit,
    val onEntrance: (String?) -> Unit,
    val onSource: (SourceKind) -> Unit,
    val onPickRecording: () -> Unit,
    val onDone: () -> Unit,
)

@Composable
fun SetupScreen(state: SetupUiState, actions: SetupActions) {
    Surface(Modifier.fillMaxSize()) {
        Column(Modifier.safeDrawingPadding().padding(16.dp)) {
            when (state) {
                SetupUiState.Loading -> Unit
                SetupUiState.NoBuildings -> Text(stringResource(R.string.no_buildings), style = MaterialTheme.typography.headlineSmall)
                is SetupUiState.Ready -> Ready(state, actions)
            }
        }
    }
}

@Composable
private fun Ready(state: SetupUiState.Ready, actions: SetupActions) {
    Column(Modifier.fillMaxSize()) {
        Column(Modifier.weight(1f).verticalScroll(rememberScrollState()), Arrangement.spacedBy(16.dp)) {
            Choices(R.string.building) {
                state.buildings.forEach { Choice(it.title, it.chosen) { actions.onBuilding(it.id.orEmpty()) } }
            }
            if (state.entrances.isNotEmpty()) {
                Choices(R.string.entrance) {
                    state.entrances.forEach { Choice(it.title, it.chosen) { actions.onEntrance(it.id) } }
                }
            }
            Choices(R.string.belt) {
                state.sources.forEach { source ->
                    Choice(stringResource(source.kind.title), source.chosen && source.available, source.available) {
                        actions.onSource(source.kind)
                    }
                }
            }
            OutlinedButton(actions.onPickRecording, Modifier.fillMaxWidth().heightIn(min = 48.dp)) {
                Text(stringResource(R.string.pick_recording))
            }
            state.recordingProblem?.let {
                Text(stringResource(R.string.recording_unusable, it), color = MaterialTheme.colorScheme.error)
            }
        }
        Button(actions.onDone, Modifier.fillMaxWidth().padding(top = 12.dp).heightIn(min = 72.dp), enabled = state.complete) {
            Text(stringResource(R.string.done), style = MaterialTheme.typography.titleLarge)
        }
    }
}

@Composable
private fun Choices(title: Int, choices: @Composable () -> Unit) {
    Column(Modifier.selectableGroup()) {
        Text(stringResource(title), Modifier.semantics { heading() }, style = MaterialTheme.typography.titleLarge)
        choices()
    }
}

@Composable
private fun Choice(title: String, chosen: Boolean, enabled: Boolean = true, onChoose: () -> Unit) {
    Row(
        Modifier.fillMaxWidth().heightIn(min = 56.dp).selectable(chosen, enabled, Role.RadioButton, onClick = onChoose),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        // The whole row is the target; a second one inside it would be read twice.
        RadioButton(chosen, onClick = null, Modifier.padding(horizontal = 12.dp), enabled)
        val colours = MaterialTheme.colorScheme
        Text(title, style = MaterialTheme.typography.bodyLarge, color = if (enabled) colours.onSurface else colours.onSurfaceVariant)
    }
}

private val SourceKind.title
    get() = when (this) {
        SourceKind.USB -> R.string.source_usb
        SourceKind.SIMULATED_WALK -> R.string.source_simulated
        SourceKind.RECORDING -> R.string.source_recording
    }
