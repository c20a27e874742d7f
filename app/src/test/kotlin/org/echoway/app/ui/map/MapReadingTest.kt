package org.echoway.app.ui.map

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.junit4.ComposeTestRule
import androidx.compose.ui.test.junit4.v2.createComposeRule
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import org.echoway.app.engine.Picture
import org.echoway.app.screens.spokenLines
import org.echoway.app.screens.torgersen
import org.echoway.app.testing.SamplePlan
import org.echoway.app.ui.EchowayTheme
import org.echoway.app.ui.live.LiveActions
import org.echoway.app.ui.live.LiveScreen
import org.echoway.app.ui.live.LiveUiState
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Point
import org.echoway.core.Route
import org.echoway.core.Spot
import org.echoway.core.Waypoint
import org.echoway.core.WaypointKind
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** The map as a screen reader tells it. */
@RunWith(AndroidJUnit4::class)
@Config(qualifiers = "w400dp-h860dp-mdpi")
class MapReadingTest {
    @get:Rule val rule = createComposeRule()

    private fun show(state: LiveUiState) =
        rule.setContent { EchowayTheme { LiveScreen(state, LiveActions({}, {}, {}, {}, {})) } }

    private fun sample(picture: Picture = Picture()) = LiveUiState.On(
        "Sample", SamplePlan.plan, "Room 1, Office.", "", SamplePlan.estimate(0, 2.0, 2.0), 0, voiceMissing = false,
        picture,
    )

    @Test fun aSentenceThenRoomByRoomTheNearestFirst() {
        show(sample())
        assertEquals(
            listOf(
                "Map of Sample, level 0. 2 rooms, 1 exit. You are in Room 1, Office.",
                "Room 1, Office. You are here. Door to Room 4. Exit: Main entrance.",
                "Room 4, Seminar room. East of you, 25 feet. Door to Room 1. Here: Lectern.",
            ),
            rule.mapLines().take(3),
        )
    }

    /** All rooms of a large building would stand between a wearer and "Start". */
    @Test fun whatCanBePressedComesBeforeTheMap() {
        show(LiveUiState.Off("Sample", SamplePlan.plan))
        assertEquals(listOf("Sample", "Guidance is off.", "Start", "Setup", "Menu"), rule.spokenLines().take(5))
    }

    @Test fun whereAmIComesBeforeTheMap() {
        show(sample())
        assertEquals(listOf("Sample", "Room 1, Office.", "Where am I?", "Stop", "Menu"), rule.spokenLines().take(5))
    }

    private fun ComposeTestRule.mapLines() = spokenLines().dropWhile { !it.startsWith("Map of") }

    @Test fun theLaboratoryAsDocumented() {
        val four = torgersen.rooms.indexOfFirst { it.id == "4" }
        show(
            LiveUiState.On(
                torgersen.name,
                torgersen,
                "Room 4, Seminar room.",
                "",
                SamplePlan.estimate(four, 2.4, 2.6),
                3,
                voiceMissing = false,
            ),
        )
        val page = File(System.getProperty("echoway.root")!!, "docs/screens.md").readText().replace(Regex("\\s+"), " ")
        for (line in rule.mapLines().take(4)) assertTrue("docs/screens.md does not have: $line", line in page)
    }

    @Test fun theWayAheadIsPartOfTheSentence() {
        val way = listOf(
            Waypoint(Spot(0, Point(2.0, 2.0)), WaypointKind.START, -1, null),
            Waypoint(Spot(0, Point(6.0, 2.0)), WaypointKind.DOOR, 0, Spot(1, Point(0.0, 2.0))),
            Waypoint(Spot(1, Point(5.0, 3.0)), WaypointKind.GOAL, -1, null),
        )
        val lectern = Destination(DestinationKind.PLACE, 0)
        show(sample(Picture(Route(way, 9.1, 0.4, usesStairs = false, usesElevator = false, lectern))))
        rule.onNodeWithContentDescription("The way has 30 feet left.", substring = true).assertIsDisplayed()
    }

    @Test fun theFingerFindsTheRoomThatIsDrawnBelowIt() {
        show(LiveUiState.Off(torgersen.name, torgersen))
        val names = Regex("(Room \\d|Hall)[.,].*")
        val rooms = rule.onAllNodes(
            SemanticsMatcher("room") {
                it.config.getOrNull(SemanticsProperties.ContentDescription)?.first()?.let(names::matches) == true
            },
        )
            .fetchSemanticsNodes()
        assertEquals(torgersen.rooms.size, rooms.size)
        val hall =
            rooms.single { it.config[SemanticsProperties.ContentDescription].first().startsWith("Hall") }.boundsInRoot
        val six =
            rooms.single { it.config[SemanticsProperties.ContentDescription].first().startsWith("Room 6") }.boundsInRoot
        assertTrue("the hall lies below room 6 and is larger", hall.top > six.bottom && hall.width > six.width)
    }

    @Test fun theMapTurnsAndFollowsAtATouchOfAButton() {
        show(sample())
        rule.onNodeWithContentDescription("Heading up").performClick()
        rule.onNodeWithContentDescription("North up").assertIsDisplayed()
        rule.onNodeWithContentDescription("Follow me").performClick()
        rule.onNodeWithContentDescription("Whole level").performClick()
        rule.onNodeWithContentDescription("Follow me").assertIsDisplayed()
    }

    @Test fun buildingsWithSeveralLevelsAreGoneThroughLevelByLevel() {
        val upstairs =
            SamplePlan.plan.copy(rooms = SamplePlan.plan.rooms.mapIndexed { i, room -> room.copy(level = i) })
        show(LiveUiState.Off("Sample", upstairs))
        rule.onNodeWithText("Level 0").performClick()
        rule.onNodeWithContentDescription("Room 4, Seminar room.", substring = true).assertIsDisplayed()
        rule.onNodeWithText("Level 1").performClick()
        rule.onNodeWithContentDescription("Room 1, Office.", substring = true).assertIsDisplayed()
    }
}
