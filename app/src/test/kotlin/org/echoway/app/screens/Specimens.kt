package org.echoway.app.screens

import android.content.Context
import androidx.compose.runtime.Composable
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.platform.LocalResources
import androidx.test.core.app.ApplicationProvider
import kotlinx.coroutines.runBlocking
import org.echoway.app.building.BundledBuildings
import org.echoway.app.engine.Picture
import org.echoway.app.guide.Wording
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
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Door
import org.echoway.core.Plan
import org.echoway.core.Point
import org.echoway.core.Route
import org.echoway.core.Spot
import org.echoway.core.Waypoint
import org.echoway.core.WaypointKind

/** Every screen of the app. */
fun specimens(): List<Specimen> = liveSpecimens() + choosingSpecimens() + dataSpecimens() + wearerSpecimens()

/** The plan of the Torgersen laboratory, through the core. */
internal val torgersen: Plan by lazy {
    runBlocking {
        BundledBuildings(ApplicationProvider.getApplicationContext<Context>(), 1).find("torgersen-lab")!!.plan
    }
}

/** "Room 4, Seminar room.": the room's name is the plan's own in every language. */
@Composable
internal fun whereOneIs() = Wording(LocalResources.current).room(torgersen.rooms.first { it.id == "4" })

/** A line of the core's, which is not asked for it here: pictures are of English and German. */
@Composable
internal fun inItsLanguage(english: String, german: String) =
    if (LocalConfiguration.current.locales[0].language == "de") german else english

@Composable
private fun tracking() = LiveUiState.On(
    building = torgersen.name,
    plan = torgersen,
    words = whereOneIs(),
    lastLine = inItsLanguage("Door behind you, eight feet.", "Tür hinter Ihnen, zweieinhalb Meter."),
    wearer = SamplePlan.estimate(
        room = torgersen.rooms.indexOfFirst { it.id == "4" }, x = 2.4, y = 2.6, headingDegrees = 30.0, sigmaM = 0.4,
    ),
    level = 3,
    voiceMissing = false,
    picture = pictureToHall(),
)

/** From room 4 through the corridor and room 1 to the hall; the wearer came from room 3. */
private fun pictureToHall(): Picture {
    fun room(id: String) = torgersen.rooms.indexOfFirst { it.id == id }
    fun door(from: String, to: String) =
        torgersen.doors.first { setOf(it.a.room, it.b.room) == setOf(room(from), room(to)) }
    fun Door.through(from: String, to: String) =
        Waypoint(Spot(room(from), seenFrom(room(from))!!), WaypointKind.DOOR, 0, Spot(room(to), seenFrom(room(to))!!))
    val here = Spot(room("4"), Point(2.4, 2.6))
    val doors = listOf("4" to "2", "2" to "1", "1" to "hall").map { (from, to) -> door(from, to).through(from, to) }
    val goal = doors.last().next!!.let { it.copy(at = Point(it.at.x, it.at.y - 3.0)) }
    val way = listOf(Waypoint(here, WaypointKind.START, -1, null)) + doors + Waypoint(goal, WaypointKind.GOAL, -1, null)
    val came = door("3", "2").seenFrom(room("3"))!!
    val trail = (0..8).map { Spot(room("3"), Point(came.x + it * 0.3, came.y)) }
    return Picture(
        Route(
            way, 14.0, 0.4, usesStairs = false, usesElevator = false, Destination(DestinationKind.ROOM, room("hall")),
        ),
        trail,
    )
}

private fun live(name: String, variants: Set<Variant> = LIGHT_ONLY, state: @Composable () -> LiveUiState) =
    Specimen(name, variants) { LiveScreen(state(), LiveActions({}, {}, {}, {}, {})) }

private fun liveSpecimens() = listOf(
    live("live-tracking", USUAL + Variant.SMOKE + Variant.GERMAN_LARGE_TEXT) { tracking() },
    live("live-no-voice") {
        tracking().copy(
            words = "Belt disconnected.", lastLine = "Belt disconnected.", wearer = null, voiceMissing = true,
        )
    },
    live("live-off") { LiveUiState.Off(torgersen.name, torgersen) },
    live("live-failed") {
        LiveUiState.Failed("Cannot start. The floor plan is unusable.", "building.cfg:3: there is no room 12")
    },
    live("live-needs-setup") { LiveUiState.NeedsSetup },
)

private fun choosingSpecimens() = listOf(
    Specimen("menu") { MenuScreen({}, {}) },
    Specimen("settings") { SettingsScreen(Settings(), {}, {}) },
    Specimen("setup-no-buildings", emptySet()) {
        SetupScreen(SetupUiState.NoBuildings, SetupActions({}, {}, {}, {}, {}))
    },
    Specimen("setup") { SetupScreen(setup(), SetupActions({}, {}, {}, {}, {})) },
)

private fun setup() = SetupUiState.Ready(
    buildings = listOf(Option("a", "Torgersen laboratory", true), Option("b", "Similar rooms", false)),
    entrances = listOf(Option(null, "", false), Option("m", "Main entrance", true), Option("e", "East stairs", false)),
    sources = SourceKind.entries.map { SourceOption(it, it == SourceKind.USB, it != SourceKind.RECORDING) },
    recordingProblem = null,
)
