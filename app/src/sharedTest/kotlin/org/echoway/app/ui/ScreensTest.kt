package org.echoway.app.ui

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertHeightIsAtLeast
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsEnabled
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.junit4.v2.createComposeRule
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.unit.dp
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.SamplePlan
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveUiState
import org.echoway.app.ui.setup.Option
import org.echoway.app.ui.setup.SetupActions
import org.echoway.app.ui.setup.SetupScreen
import org.echoway.app.ui.setup.SetupUiState
import org.echoway.app.ui.setup.SourceOption
import org.junit.Assert.assertEquals
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith

/** The screens, on the host and on devices. */
@RunWith(AndroidJUnit4::class)
class ScreensTest {
    @get:Rule val rule = createComposeRule()

    private val done = mutableListOf<String>()

    private fun live(state: LiveUiState) = rule.setContent {
        EchowayTheme {
            LiveScreen(
                state,
                LiveActions(
                    { done += "where" },
                    { done += "start" },
                    { done += "stop" },
                    { done += "setup" },
                    { done += "menu" },
                ),
            )
        }
    }

    private fun setup(state: SetupUiState) = rule.setContent {
        EchowayTheme {
            SetupScreen(
                state,
                SetupActions(
                    { done += "building $it" },
                    { done += "entrance $it" },
                    { done += "source $it" },
                    { done += "pick" },
                    { done += "done" },
                ),
            )
        }
    }

    private val on = LiveUiState.On(
        building = "Sample",
        plan = SamplePlan.plan,
        words = "Room 1, Office.",
        lastLine = "Door right, six feet.",
        wearer = SamplePlan.estimate(0, 2.0, 2.0),
        level = 0,
        voiceMissing = false,
    )

    @Test fun theLiveScreenSaysWhereOneIsAndAnswers() {
        live(on)
        rule.onNodeWithContentDescription(
            "Map of Sample, level 0. 2 rooms, 1 exit. You are in Room 1, Office.",
        ).assertIsDisplayed()
        rule.onNodeWithText("Door right, six feet.").assertIsDisplayed()
        rule.onNodeWithText("Where am I?").assertHeightIsAtLeast(100.dp).performClick()
        rule.onNodeWithText("Stop").assertHeightIsAtLeast(48.dp).performClick()
        rule.onNodeWithText("Menu").assertHeightIsAtLeast(48.dp).performClick()
        assertEquals(listOf("where", "stop", "menu"), done)
    }

    @Test fun aPhoneWithoutAVoiceSaysSoOnTheScreen() {
        live(on.copy(voiceMissing = true))
        rule.onNodeWithText("No voice: tones and vibration.").assertIsDisplayed()
    }

    @Test fun whatCouldNotBeginCanBeTriedAgain() {
        live(LiveUiState.Failed("Cannot start. The floor plan is unusable.", "building.cfg:3: no such room"))
        rule.onNodeWithText("building.cfg:3: no such room").assertIsDisplayed()
        rule.onNodeWithText("Start").performClick()
        rule.onNodeWithText("Setup").performClick()
        assertEquals(listOf("start", "setup"), done)
    }

    @Test fun withoutAVoiceTheScreenSaysSoBeforeTheStart() {
        live(LiveUiState.Off("Sample", SamplePlan.plan, voiceMissing = true))
        rule.onNodeWithText("No voice: tones and vibration.").assertIsDisplayed()
        rule.onNodeWithText("Install a speech engine to hear guidance.").assertIsDisplayed()
    }

    @Test fun withoutABuildingThereIsOneThingToDo() {
        live(LiveUiState.NeedsSetup)
        rule.onNodeWithText("Choose the building you are in.").assertIsDisplayed()
        rule.onNodeWithText("Setup").performClick()
        assertEquals(listOf("setup"), done)
    }

    @Test fun guidanceThatIsOffCanBeStarted() {
        live(LiveUiState.Off("Sample", SamplePlan.plan))
        rule.onNodeWithText("Start").performClick()
        assertEquals(listOf("start"), done)
    }

    private fun ready(building: Boolean) = SetupUiState.Ready(
        buildings = listOf(Option("sample", "Sample", building)),
        entrances = if (building) listOf(Option(null, "", true), Option("Main", "Main", false)) else emptyList(),
        sources = SourceKind.entries.map { SourceOption(it, it == SourceKind.USB, it != SourceKind.RECORDING) },
        recordingProblem = null,
    )

    @Test fun buildingEntranceAndBeltAreChosen() {
        setup(ready(building = true))
        rule.onNodeWithText("I do not know").assertIsSelected()
        rule.onNodeWithText("Main").performClick()
        rule.onNodeWithText("Simulated walk, without a belt").performClick()
        rule.onNodeWithText("Recorded walk").assertIsNotEnabled()
        rule.onNodeWithText("Done").assertIsEnabled().performClick()
        assertEquals(listOf("entrance Main", "source SIMULATED_WALK", "done"), done)
    }

    @Test fun aRecordingThatCannotBePlayedIsHeardOf() {
        setup(ready(building = true).copy(recordingProblem = "the log holds no firing"))
        rule.onNodeWithText("the log holds no firing", substring = true).assert(
            SemanticsMatcher.keyIsDefined(SemanticsProperties.LiveRegion),
        )
    }

    @Test fun withoutABuildingSetupIsNotDone() {
        setup(ready(building = false))
        rule.onNodeWithText("Done").assertIsNotEnabled()
        rule.onNodeWithText("Sample").performClick()
        assertEquals(listOf("building sample"), done)
    }
}
