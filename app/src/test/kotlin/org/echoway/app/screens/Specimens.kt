package org.echoway.app.screens

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import kotlinx.coroutines.runBlocking
import org.echoway.app.building.BundledBuildings
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.SamplePlan
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveUiState
import org.echoway.app.ui.menu.MenuScreen
import org.echoway.app.ui.settings.SettingsScreen
import org.echoway.app.ui.setup.Option
import org.echoway.app.ui.setup.SetupActions
import org.echoway.app.ui.setup.SetupScreen
import org.echoway.app.ui.setup.SetupUiState
import org.echoway.app.ui.setup.SourceOption
import org.echoway.core.Plan

/** Every screen of the app. */
fun specimens(): List<Specimen> = liveSpecimens() + choosingSpecimens() + dataSpecimens()

/** The plan of the Torgersen laboratory, through the core. */
internal val torgersen: Plan by lazy {
    runBlocking { BundledBuildings(ApplicationProvider.getApplicationContext<Context>(), 1).find("torgersen-lab")!!.plan }
}

private fun tracking() = LiveUiState.On(
    building = torgersen.name,
    plan = torgersen,
    words = "Room 4, Seminar room.",
    lastLine = "Door behind you, eight feet.",
    wearer = SamplePlan.estimate(room = torgersen.rooms.indexOfFirst { it.id == "4" }, x = 2.4, y = 2.6, headingDegrees = 30.0, sigmaM = 0.4),
    level = 3,
    voiceMissing = false,
    permissionMissing = false,
)

private fun live(name: String, variants: Set<Variant> = LIGHT_ONLY, state: () -> LiveUiState) =
    Specimen(name, variants) { LiveScreen(state(), LiveActions({}, {}, {}, {}, {})) }

private fun liveSpecimens() = listOf(
    live("live-tracking", Variant.entries.toSet(), ::tracking),
    live("live-no-voice") { tracking().copy(words = "Belt disconnected.", lastLine = "Belt disconnected.", wearer = null, voiceMissing = true) },
    live("live-off") { LiveUiState.Off(torgersen.name, torgersen) },
    live("live-needs-setup") { LiveUiState.NeedsSetup },
)

private fun choosingSpecimens() = listOf(
    Specimen("menu") { MenuScreen({}, {}) },
    Specimen("settings") { SettingsScreen(Settings(), {}, {}) },
    Specimen("setup") { SetupScreen(setup(), SetupActions({}, {}, {}, {}, {})) },
)

private fun setup() = SetupUiState.Ready(
    buildings = listOf(Option("a", "Torgersen laboratory", true), Option("b", "Similar rooms", false)),
    entrances = listOf(Option(null, "I do not know", false), Option("m", "Main entrance", true), Option("e", "East stairs", false)),
    sources = SourceKind.entries.map { SourceOption(it, it == SourceKind.USB, it != SourceKind.RECORDING) },
    recordingProblem = null,
)
