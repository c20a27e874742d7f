package org.echoway.app.ui.setup

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
import java.io.IOException
import java.io.InputStream
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.stateIn
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.echoway.app.AppContainer
import org.echoway.app.belt.WalkLog
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.copyAtMost
import org.echoway.app.recording.Recordings
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.app.ui.common.WHILE_SHOWN

/** Choosing building, entrance and belt source. */
class SetupViewModel(private val container: AppContainer) : ViewModel() {
    private val problem = MutableStateFlow<String?>(null)

    val uiState: StateFlow<SetupUiState> =
        combine(
            container.buildings.revision.map { container.buildings.all() },
            container.settings.settings,
            problem,
            ::show,
        )
            .stateIn(viewModelScope, WHILE_SHOWN, SetupUiState.Loading)

    fun chooseBuilding(id: String) = update { if (it.building == id) it else it.copy(building = id, entrance = null) }

    fun chooseEntrance(name: String?) = update { it.copy(entrance = name) }

    fun chooseSource(kind: SourceKind) = update { it.copy(source = kind) }

    /** Keeps a copy of a scan log that the wearer picked, and chooses it; a log that cannot be played is refused. */
    fun useRecording(name: String, open: () -> InputStream) {
        viewModelScope.launch {
            val file = File(
                container.recordings.folder,
                File(name).name.let {
                    if (it.endsWith(Recordings.SCANS)) it else it.removeSuffix(".csv") + Recordings.SCANS
                },
            )
            problem.value = try {
                withContext(Dispatchers.IO) { keep(file, open) }
                container.settings.update { it.copy(source = SourceKind.RECORDING, recording = file.name) }
                null
            } catch (e: IOException) {
                e.message.orEmpty()
            }
        }
    }

    private fun keep(file: File, open: () -> InputStream) {
        val partial = File(container.cacheDir, "picked")
        try {
            open().use { it.copyAtMost(MOST_BYTES, partial) } ?: throw IOException("larger than any recorded walk")
            WalkLog.read(partial.bufferedReader())
            container.recordings.folder.mkdirs()
            partial.copyTo(file, overwrite = true)
        } finally {
            partial.delete()
        }
    }

    private fun update(change: (Settings) -> Settings) {
        viewModelScope.launch { container.settings.update(change) }
    }

    private fun show(buildings: List<InstalledBuilding>, settings: Settings, problem: String?): SetupUiState {
        if (buildings.isEmpty()) return SetupUiState.NoBuildings
        val chosen = buildings.firstOrNull { it.id == settings.building }
        return SetupUiState.Ready(
            buildings = buildings.map { Option(it.id, it.title, it === chosen) },
            entrances = chosen?.let { entrances(it, settings) }.orEmpty(),
            sources = SourceKind.entries.map { kind ->
                SourceOption(kind, kind == settings.source, available(kind, settings, chosen))
            },
            recordingProblem = problem,
        )
    }

    private fun entrances(building: InstalledBuilding, settings: Settings): List<Option> {
        val named = building.plan.exits.map { it.name }.filter { it.isNotEmpty() }.distinct()
        return listOf(Option(null, "", settings.entrance !in named)) +
            named.map { Option(it, it, it == settings.entrance) }
    }

    private fun available(kind: SourceKind, settings: Settings, building: InstalledBuilding?) = when (kind) {
        SourceKind.USB -> true
        SourceKind.SIMULATED_WALK -> building != null && container.hasSimulatedWalk(building.id)
        SourceKind.RECORDING -> settings.recording != null
    }

    private companion object {
        /** A day of walking. */
        const val MOST_BYTES = 32L shl 20
    }
}
