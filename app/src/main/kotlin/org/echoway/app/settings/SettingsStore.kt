package org.echoway.app.settings

import kotlinx.coroutines.flow.Flow

/** Settings that outlive the app's process. */
interface SettingsStore {
    val settings: Flow<Settings>

    suspend fun update(change: (Settings) -> Settings)
}
