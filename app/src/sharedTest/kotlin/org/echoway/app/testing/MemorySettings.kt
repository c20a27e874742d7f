package org.echoway.app.testing

import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SettingsStore

/** Settings that last as long as the test. */
class MemorySettings(initial: Settings = Settings()) : SettingsStore {
    override val settings = MutableStateFlow(initial)

    /** How long the phone takes to write a change down. */
    var slowMs = 0L

    override suspend fun update(change: (Settings) -> Settings) {
        delay(slowMs)
        settings.value = change(settings.value)
    }
}
