package org.echoway.app.settings

import androidx.datastore.core.DataStore
import androidx.datastore.preferences.core.Preferences
import androidx.datastore.preferences.core.edit
import androidx.datastore.preferences.core.stringPreferencesKey
import androidx.test.ext.junit.runners.AndroidJUnit4
import app.cash.turbine.test
import java.io.File
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.runBlocking
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.DirectionStyle
import org.echoway.core.Language
import org.echoway.core.LengthStyle
import org.junit.Assert.assertEquals
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class DataStoreSettingsTest {
    @get:Rule val temporary = TemporaryFolder()

    private val folder by lazy { File(temporary.root, "kept") }
    private val file by lazy { File(folder, "settings.preferences_pb") }

    /** As one life of the app's process has it. */
    private fun <T> alive(work: suspend (DataStoreSettings, DataStore<Preferences>) -> T): T = runBlocking {
        val job = Job()
        val store = DataStoreSettings.inFile(CoroutineScope(Dispatchers.IO + job)) { file }
        work(DataStoreSettings(store), store).also { job.cancelAndJoin() }
    }

    private val unusual = Settings(
        building = "torgersen-lab", entrance = "Main entrance", source = SourceKind.RECORDING,
        recording = "a.scans.csv", navigating = true,
        walkedS = 1234.5, goal = Goal("my own house", Destination(DestinationKind.PLACE, 3)),
        service = ServiceModel.ON_REQUEST, verbosity = Verbosity.FULL,
        directions = DirectionStyle.CLOCK, lengths = LengthStyle.METRES, avoidStairs = true,
        firefighter = true, notMovedAlertS = 60, language = Language.FRENCH, theme = ThemeChoice.SMOKE,
        vibration = false, motion = false, volumeKeys = false, record = true, introduced = true,
    )

    @Test fun everythingOutlivesTheProcess() {
        val usual = Settings()
        val properties = Settings::class.java.declaredFields
            .filter { !java.lang.reflect.Modifier.isStatic(it.modifiers) }
            .onEach { it.isAccessible = true }
        assertEquals(
            "all differ from what is usual",
            emptyList<String>(),
            properties.filter { it[usual] == it[unusual] }.map { it.name },
        )
        alive { settings, _ -> settings.update { unusual } }
        assertEquals(unusual, alive { settings, _ -> settings.settings.first() })
        alive { settings, _ -> settings.update { usual } }
        assertEquals(usual, alive { settings, _ -> settings.settings.first() })
    }

    @Test fun whatAnotherVersionWroteFallsBackToWhatIsUsual() {
        alive { _, store -> store.edit { it[stringPreferencesKey("theme")] = "SEPIA" } }
        alive { _, store -> store.edit { it[stringPreferencesKey("goal")] = "BALCONY 3 torgersen-lab" } }
        assertEquals(Settings(), alive { settings, _ -> settings.settings.first() })
    }

    @Test fun whatIsLeftOfAFileThatWasNotWrittenToItsEndIsNoReasonNotToBegin() {
        folder.mkdirs()
        file.writeBytes(byteArrayOf(0x0A, 0x7F, 0x01))
        alive { settings, _ -> settings.update { it.copy(firefighter = true) } }
        assertEquals(Settings(firefighter = true), alive { settings, _ -> settings.settings.first() })
    }

    /** Guidance notes down every minute that somebody walks. */
    @Test fun whatAPhoneThatIsFullCannotKeepHoldsUntilTheAppEndsAndIsKeptOnceThereIsRoom() = alive { settings, _ ->
        folder.writeText("where the folder should be")
        settings.update { it.copy(navigating = true) }
        settings.update { it.copy(walkedS = 60.0) }
        assertEquals(Settings(navigating = true, walkedS = 60.0), settings.settings.first())
        folder.delete()
        settings.update { it.copy(walkedS = 120.0) }
        assertEquals(Settings(navigating = true, walkedS = 120.0), settings.settings.first())
        assertEquals(true, file.isFile)
    }

    @Test fun aChangeIsSeenAtOnce() = alive { settings, _ ->
        settings.settings.test {
            assertEquals(Settings(), awaitItem())
            settings.update { it.copy(lengths = LengthStyle.STEPS) }
            assertEquals(LengthStyle.STEPS, awaitItem().lengths)
            cancelAndIgnoreRemainingEvents()
        }
    }
}
