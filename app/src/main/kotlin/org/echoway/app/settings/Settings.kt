package org.echoway.app.settings

import androidx.datastore.core.DataStore
import androidx.datastore.preferences.core.Preferences
import androidx.datastore.preferences.core.booleanPreferencesKey
import androidx.datastore.preferences.core.edit
import androidx.datastore.preferences.core.emptyPreferences
import androidx.datastore.preferences.core.stringPreferencesKey
import java.io.IOException
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.catch
import kotlinx.coroutines.flow.map

/** Where echoes come from. */
enum class SourceKind { USB, SIMULATED_WALK, RECORDING }

/**
 * What the wearer chose.
 *
 * @property building id of the floor plan; null until one was chosen
 * @property entrance name of the way in; null when the wearer does not know it
 * @property recording file name of the log to replay, for [SourceKind.RECORDING]
 * @property navigating whether guidance was on when the app was last alive, so that it goes on after its death
 */
data class Settings(
    val building: String? = null,
    val entrance: String? = null,
    val source: SourceKind = SourceKind.USB,
    val recording: String? = null,
    val navigating: Boolean = false,
)

/** Settings that outlive the app's process. */
interface SettingsStore {
    val settings: Flow<Settings>

    suspend fun update(change: (Settings) -> Settings)
}

class DataStoreSettings(private val store: DataStore<Preferences>) : SettingsStore {
    override val settings: Flow<Settings> = store.data
        .catch { if (it is IOException) emit(emptyPreferences()) else throw it }
        .map(::read)

    override suspend fun update(change: (Settings) -> Settings) {
        store.edit { preferences ->
            val changed = change(read(preferences))
            preferences.put(BUILDING, changed.building)
            preferences.put(ENTRANCE, changed.entrance)
            preferences.put(RECORDING, changed.recording)
            preferences[SOURCE] = changed.source.name
            preferences[NAVIGATING] = changed.navigating
        }
    }

    private fun read(preferences: Preferences) = Settings(
        building = preferences[BUILDING],
        entrance = preferences[ENTRANCE],
        source = SourceKind.entries.firstOrNull { it.name == preferences[SOURCE] } ?: SourceKind.USB,
        recording = preferences[RECORDING],
        navigating = preferences[NAVIGATING] ?: false,
    )

    private fun androidx.datastore.preferences.core.MutablePreferences.put(key: Preferences.Key<String>, value: String?) {
        if (value == null) remove(key) else set(key, value)
    }

    private companion object {
        val BUILDING = stringPreferencesKey("building")
        val ENTRANCE = stringPreferencesKey("entrance")
        val SOURCE = stringPreferencesKey("source")
        val RECORDING = stringPreferencesKey("recording")
        val NAVIGATING = booleanPreferencesKey("navigating")
    }
}
