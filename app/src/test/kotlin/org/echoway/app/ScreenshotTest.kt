package org.echoway.app

import android.content.Context
import androidx.compose.runtime.Composable
import androidx.compose.ui.test.junit4.v2.createComposeRule
import androidx.compose.ui.test.onRoot
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import com.github.takahirom.roborazzi.captureRoboImage
import kotlinx.coroutines.runBlocking
import org.echoway.app.building.BundledBuildings
import org.echoway.app.settings.SourceKind
import org.echoway.app.settings.ThemeChoice
import org.echoway.app.testing.SamplePlan
import org.echoway.app.ui.EchowayTheme
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveUiState
import org.echoway.app.ui.setup.Option
import org.echoway.app.ui.setup.SetupActions
import org.echoway.app.ui.setup.SetupScreen
import org.echoway.app.ui.setup.SetupUiState
import org.echoway.app.ui.setup.SourceOption
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** Every screen against its golden picture in `app/screenshots/`; `make screenshots` draws them anew. */
@RunWith(AndroidJUnit4::class)
@Config(qualifiers = "w400dp-h860dp-xhdpi")
class ScreenshotTest {
    @get:Rule val rule = createComposeRule()

    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val plan by lazy { runBlocking { BundledBuildings(context, 1).find("torgersen-lab")!!.plan } }

    private fun shoot(name: String, dark: Boolean = false, screen: @Composable () -> Unit) {
        rule.setContent { EchowayTheme(if (dark) ThemeChoice.DARK else ThemeChoice.LIGHT, screen) }
        rule.onRoot().captureRoboImage(System.getProperty("echoway.root")!! + "/app/screenshots/$name.png")
    }

    private fun live(name: String, state: LiveUiState, dark: Boolean = false) =
        shoot(name, dark) { LiveScreen(state, LiveActions({}, {}, {}, {}, {})) }

    private fun tracking() = LiveUiState.On(
        building = plan.name,
        plan = plan,
        words = "Room 4, Seminar room.",
        lastLine = "Door behind you, eight feet.",
        wearer = SamplePlan.estimate(room = plan.rooms.indexOfFirst { it.id == "4" }, x = 2.4, y = 2.6, headingDegrees = 30.0, sigmaM = 0.4),
        level = 3,
        voiceMissing = false,
        permissionMissing = false,
    )

    @Test fun trackingInLight() = live("live-tracking", tracking())

    @Test fun trackingInTheDark() = live("live-tracking-dark", tracking(), dark = true)

    @Test fun withoutVoice() = live(
        "live-no-voice",
        tracking().copy(words = "Belt disconnected.", lastLine = "Belt disconnected.", wearer = null, voiceMissing = true),
    )

    @Test fun off() = live("live-off", LiveUiState.Off(plan.name, plan))

    @Test fun needsSetup() = live("live-needs-setup", LiveUiState.NeedsSetup)

    @Test
    @Config(fontScale = 2f)
    fun trackingWithLargeText() = live("live-tracking-large-text", tracking())

    @Test fun setup() = shoot("setup") {
        SetupScreen(
            SetupUiState.Ready(
                buildings = listOf(Option("a", "Torgersen laboratory", true), Option("b", "Similar rooms", false)),
                entrances = listOf(Option(null, "I do not know", false), Option("m", "Main entrance", true), Option("e", "East stairs", false)),
                sources = SourceKind.entries.map { SourceOption(it, it == SourceKind.USB, it != SourceKind.RECORDING) },
                recordingProblem = null,
            ),
            SetupActions({}, {}, {}, {}, {}),
        )
    }
}
