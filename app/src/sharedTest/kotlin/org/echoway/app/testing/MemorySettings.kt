package org.echoway.app.testing

import kotlinx.coroutines.flow.MutableStateFlow
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SettingsStore

/** Settings that last as long as the test. */
class MemorySettings(initial: Settings = Settings()) : SettingsStore {
    override val settings = MutableStateFlow(initial)

    override suspend fun update(change: (Settings) -> Settings) {
        settings.value = change(settings.value)
    }
}
