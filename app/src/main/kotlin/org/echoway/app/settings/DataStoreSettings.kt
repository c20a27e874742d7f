package org.echoway.app.settings

import androidx.datastore.core.DataStore
import androidx.datastore.core.handlers.ReplaceFileCorruptionHandler
import androidx.datastore.preferences.core.MutablePreferences
import androidx.datastore.preferences.core.PreferenceDataStoreFactory
import androidx.datastore.preferences.core.Preferences
import androidx.datastore.preferences.core.booleanPreferencesKey
import androidx.datastore.preferences.core.doublePreferencesKey
import androidx.datastore.preferences.core.edit
import androidx.datastore.preferences.core.emptyPreferences
import androidx.datastore.preferences.core.intPreferencesKey
import androidx.datastore.preferences.core.stringPreferencesKey
import java.io.File
import java.io.IOException
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.catch
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import org.echoway.core.DirectionStyle
import org.echoway.core.Language
import org.echoway.core.LengthStyle

/** Settings in a file. What a phone that is full cannot keep holds all the same until the app ends. */
class DataStoreSettings(private val store: DataStore<Preferences>) : SettingsStore {
    private val unwritten = MutableStateFlow<Settings?>(null)
    private val writing = Mutex()

    override val settings: Flow<Settings> = store.data
        .catch { if (it is IOException) emit(emptyPreferences()) else throw it }
        .combine(unwritten) { kept, held -> held ?: read(kept) }
        .distinctUntilChanged()

    override suspend fun update(change: (Settings) -> Settings) = writing.withLock {
        val changed = change(settings.first())
        try {
            store.edit { write(it, changed) }
            unwritten.value = null
        } catch (_: IOException) {
            unwritten.value = changed
        }
    }

    private fun write(preferences: MutablePreferences, changed: Settings) {
        preferences.put(BUILDING, changed.building)
        preferences.put(ENTRANCE, changed.entrance)
        preferences.put(RECORDING, changed.recording)
        preferences[SOURCE] = changed.source.name
        preferences[NAVIGATING] = changed.navigating
        preferences.put(WALKED_S, changed.walkedS)
        preferences.put(GOAL, changed.goal?.written())
        preferences[SERVICE] = changed.service.name
        preferences[VERBOSITY] = changed.verbosity.name
        preferences[DIRECTIONS] = changed.directions.name
        preferences[LENGTHS] = changed.lengths.name
        preferences[AVOID_STAIRS] = changed.avoidStairs
        preferences[FIREFIGHTER] = changed.firefighter
        preferences[NOT_MOVED_ALERT_S] = changed.notMovedAlertS
        preferences.put(LANGUAGE, changed.language?.name)
        preferences[THEME] = changed.theme.name
        preferences[VIBRATION] = changed.vibration
        preferences[MOTION] = changed.motion
        preferences[VOLUME_KEYS] = changed.volumeKeys
        preferences[RECORD] = changed.record
        preferences[INTRODUCED] = changed.introduced
    }

    private fun read(preferences: Preferences) = Settings(
        building = preferences[BUILDING],
        entrance = preferences[ENTRANCE],
        source = preferences.choice(SOURCE, SourceKind.USB),
        recording = preferences[RECORDING],
        navigating = preferences[NAVIGATING] ?: false,
        walkedS = preferences[WALKED_S],
        goal = preferences[GOAL]?.let(Goal::read),
        service = preferences.choice(SERVICE, ServiceModel.CONTINUOUS),
        verbosity = preferences.choice(VERBOSITY, Verbosity.NORMAL),
        directions = preferences.choice(DIRECTIONS, DirectionStyle.SIDES),
        lengths = preferences.choice(LENGTHS, LengthStyle.FEET),
        avoidStairs = preferences[AVOID_STAIRS] ?: false,
        firefighter = preferences[FIREFIGHTER] ?: false,
        notMovedAlertS = preferences[NOT_MOVED_ALERT_S] ?: Settings.DEFAULT_ALERT_S,
        language = preferences[LANGUAGE]?.let { name -> Language.entries.firstOrNull { it.name == name } },
        theme = preferences.choice(THEME, ThemeChoice.SYSTEM),
        vibration = preferences[VIBRATION] ?: true,
        motion = preferences[MOTION] ?: true,
        volumeKeys = preferences[VOLUME_KEYS] ?: true,
        record = preferences[RECORD] ?: false,
        introduced = preferences[INTRODUCED] ?: false,
    )

    /** What an older or newer version wrote may be no choice any more. */
    private inline fun <reified T : Enum<T>> Preferences.choice(key: Preferences.Key<String>, usual: T): T =
        enumValues<T>().firstOrNull { it.name == this[key] } ?: usual

    private fun <T> MutablePreferences.put(key: Preferences.Key<T>, value: T?) {
        if (value == null) remove(key) else set(key, value)
    }

    companion object {
        /** What a phone that died while it wrote has left is no reason not to begin: it begins with what is usual. */
        fun inFile(
            scope: CoroutineScope = CoroutineScope(Dispatchers.IO + SupervisorJob()),
            file: () -> File,
        ): DataStore<Preferences> =
            PreferenceDataStoreFactory.create(
                ReplaceFileCorruptionHandler { emptyPreferences() }, scope = scope, produceFile = file,
            )

        private val BUILDING = stringPreferencesKey("building")
        private val ENTRANCE = stringPreferencesKey("entrance")
        private val SOURCE = stringPreferencesKey("source")
        private val RECORDING = stringPreferencesKey("recording")
        private val NAVIGATING = booleanPreferencesKey("navigating")
        private val WALKED_S = doublePreferencesKey("walked s")
        private val GOAL = stringPreferencesKey("goal")
        private val SERVICE = stringPreferencesKey("service")
        private val VERBOSITY = stringPreferencesKey("verbosity")
        private val DIRECTIONS = stringPreferencesKey("directions")
        private val LENGTHS = stringPreferencesKey("lengths")
        private val AVOID_STAIRS = booleanPreferencesKey("avoid stairs")
        private val FIREFIGHTER = booleanPreferencesKey("firefighter")
        private val NOT_MOVED_ALERT_S = intPreferencesKey("not moved alert s")
        private val LANGUAGE = stringPreferencesKey("language")
        private val THEME = stringPreferencesKey("theme")
        private val VIBRATION = booleanPreferencesKey("vibration")
        private val MOTION = booleanPreferencesKey("motion")
        private val VOLUME_KEYS = booleanPreferencesKey("volume keys")
        private val RECORD = booleanPreferencesKey("record")
        private val INTRODUCED = booleanPreferencesKey("introduced")
    }
}
