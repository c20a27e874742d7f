package org.echoway.app.ui.buildings

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.InputStream
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.stateIn
import kotlinx.coroutines.launch
import org.echoway.app.building.BuildingFiles
import org.echoway.app.building.BuildingLibrary
import org.echoway.app.building.ImportException
import org.echoway.app.building.Imported
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.building.UnusableBuilding
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SettingsStore
import org.echoway.app.ui.common.WHILE_SHOWN

/** Bringing buildings in, choosing, checking and deleting them. */
class BuildingsViewModel(private val library: BuildingLibrary, private val settings: SettingsStore) : ViewModel() {
    private val notice = MutableStateFlow<BuildingNotice?>(null)
    private val asking = MutableStateFlow<BuildingItem?>(null)

    val uiState: StateFlow<BuildingsUiState> =
        combine(library.revision.map { library.all() }, settings.settings, notice, asking, ::show)
            .stateIn(viewModelScope, WHILE_SHOWN, BuildingsUiState())

    fun importZip(name: String, open: () -> InputStream) = import { library.importZip(name, open) }

    fun importFolder(name: String, files: BuildingFiles) = import { library.importFolder(name, files) }

    fun choose(item: BuildingItem) {
        viewModelScope.launch {
            settings.update { if (it.building == item.id) it else it.copy(building = item.id, entrance = null) }
        }
    }

    fun check(item: BuildingItem) {
        viewModelScope.launch {
            notice.value = BuildingNotice.Working
            notice.value = BuildingNotice.Checked(item.title, library.check(item.id))
        }
    }

    fun askDelete(item: BuildingItem?) {
        asking.value = item
    }

    fun delete(item: BuildingItem) {
        asking.value = null
        viewModelScope.launch {
            settings.update { if (it.building == item.id) it.copy(building = null, entrance = null) else it }
            library.delete(item.id)
            notice.value = BuildingNotice.Deleted(item.title)
        }
    }

    private fun import(work: suspend () -> Imported) {
        viewModelScope.launch {
            notice.value = BuildingNotice.Working
            notice.value = try {
                val imported = work()
                settings.update { it.copy(building = imported.id, entrance = null) }
                BuildingNotice.Imported(library.find(imported.id)?.title ?: imported.id, imported.findings)
            } catch (e: ImportException) {
                BuildingNotice.Refused(e.problem, e.detail)
            } catch (e: UnusableBuilding) {
                BuildingNotice.Unusable(e.findings)
            }
        }
    }

    private fun show(all: List<InstalledBuilding>, settings: Settings, notice: BuildingNotice?, asking: BuildingItem?) =
        BuildingsUiState(all.map { item(it, settings) }, notice, asking)

    private fun item(building: InstalledBuilding, settings: Settings) = BuildingItem(
        building.id, building.title, building.plan.rooms.size, building.plan.exits.size, building.imported,
        building.id == settings.building,
    )
}
