package org.echoway.app.ui.settings

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.flow.SharingStarted
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.stateIn
import kotlinx.coroutines.launch
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SettingsStore

/** The settings as they are, and changing them. Null while they are being read. */
class SettingsViewModel(private val store: SettingsStore) : ViewModel() {
    val settings: StateFlow<Settings?> = store.settings.stateIn(viewModelScope, SharingStarted.Eagerly, null)

    fun change(change: (Settings) -> Settings) {
        viewModelScope.launch { store.update(change) }
    }
}
