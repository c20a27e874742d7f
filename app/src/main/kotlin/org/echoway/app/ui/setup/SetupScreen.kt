package org.echoway.app.ui.setup

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Button
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.settings.SourceKind
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.Choice
import org.echoway.app.ui.common.Choices
import org.echoway.app.ui.common.Heading

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
                SetupUiState.NoBuildings -> {
                    Heading(stringResource(R.string.no_buildings), Modifier.weight(1f))
                    Action(stringResource(R.string.back), onClick = actions.onDone)
                }
                is SetupUiState.Ready -> Ready(state, actions)
            }
        }
    }
}

@Composable
private fun Ready(state: SetupUiState.Ready, actions: SetupActions) {
    Column(Modifier.fillMaxSize()) {
        Column(Modifier.weight(1f).verticalScroll(rememberScrollState()), Arrangement.spacedBy(16.dp)) {
            Choices(stringResource(R.string.building)) {
                state.buildings.forEach { Choice(it.title, it.chosen) { actions.onBuilding(it.id.orEmpty()) } }
            }
            if (state.entrances.isNotEmpty()) {
                Choices(stringResource(R.string.entrance)) {
                    state.entrances.forEach {
                        Choice(if (it.id == null) stringResource(R.string.entrance_unknown) else it.title, it.chosen) {
                            actions.onEntrance(it.id)
                        }
                    }
                }
            }
            Choices(stringResource(R.string.belt)) {
                state.sources.forEach { source ->
                    Choice(stringResource(source.kind.title), source.chosen && source.available, source.available) {
                        actions.onSource(source.kind)
                    }
                }
            }
            Action(stringResource(R.string.pick_recording), onClick = actions.onPickRecording)
            state.recordingProblem?.let {
                // It appears below all that is chosen: who picked the recording by ear has to hear of it.
                val heard = Modifier.semantics { liveRegion = LiveRegionMode.Assertive }
                Text(stringResource(R.string.recording_unusable, it), heard, color = MaterialTheme.colorScheme.error)
            }
        }
        Button(
            actions.onDone,
            Modifier.fillMaxWidth().padding(top = 12.dp).heightIn(min = 72.dp),
            enabled = state.complete,
        ) {
            Text(stringResource(R.string.done), style = MaterialTheme.typography.titleLarge)
        }
    }
}

private val SourceKind.title
    get() = when (this) {
        SourceKind.USB -> R.string.source_usb
        SourceKind.SIMULATED_WALK -> R.string.source_simulated
        SourceKind.RECORDING -> R.string.source_recording
    }
