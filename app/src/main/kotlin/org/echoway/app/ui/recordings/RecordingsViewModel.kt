package org.echoway.app.ui.recordings

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.stateIn
import kotlinx.coroutines.launch
import org.echoway.app.recording.Recording
import org.echoway.app.recording.RecordingStatus
import org.echoway.app.recording.Recordings
import org.echoway.app.settings.SettingsStore
import org.echoway.app.settings.SourceKind
import org.echoway.app.ui.common.WHILE_SHOWN

/** What the recordings screen shows; null [all] while the folder is being read. */
data class RecordingsUiState(
    val all: List<Recording>? = null,
    val recordWalks: Boolean = false,
    val status: RecordingStatus = RecordingStatus.Off,
    val askDelete: Recording? = null,
)

/** Turning recording on, and replaying and deleting what was recorded. */
class RecordingsViewModel(private val recordings: Recordings, private val settings: SettingsStore) : ViewModel() {
    private val asking = MutableStateFlow<Recording?>(null)

    val uiState: StateFlow<RecordingsUiState> = combine(
        combine(recordings.revision, recordings.status) { _, status -> status }.map { it to recordings.all() },
        settings.settings,
        asking,
    ) { (status, all), settings, asked -> RecordingsUiState(all, settings.record, status, asked) }
        .stateIn(viewModelScope, WHILE_SHOWN, RecordingsUiState())

    fun record(on: Boolean) {
        viewModelScope.launch { settings.update { it.copy(record = on) } }
    }

    /** Makes the recording the belt that guidance listens to, in the building where it was made; then calls [start]. */
    fun replay(recording: Recording, start: () -> Unit) {
        viewModelScope.launch {
            settings.update {
                val building = recording.building ?: it.building
                val entrance = it.entrance.takeIf { _ -> building == it.building }
                it.copy(
                    source = SourceKind.RECORDING,
                    recording = recording.scans,
                    building = building,
                    entrance = entrance,
                )
            }
            start()
        }
    }

    fun askDelete(recording: Recording?) {
        asking.value = recording
    }

    fun delete(recording: Recording) {
        asking.value = null
        viewModelScope.launch { recordings.delete(recording.name) }
    }
}
