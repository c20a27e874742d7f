package org.echoway.app.ui

import android.Manifest
import android.view.KeyEvent
import android.view.accessibility.AccessibilityManager
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.hasScrollAction
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.isHeading
import androidx.compose.ui.test.junit4.v2.createEmptyComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollToNode
import androidx.test.core.app.ActivityScenario
import androidx.test.core.app.ApplicationProvider
import androidx.test.espresso.Espresso
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import org.echoway.app.MainActivity
import org.echoway.app.control.Stillness
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.app.service.NavigationService
import org.echoway.app.service.TestApp
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.app.touch.Touch
import org.echoway.app.voice.VoiceStatus
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Language
import org.echoway.core.Start
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNotNull
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowLooper

/** First run, destinations, practice and firefighter mode in the real activity. */
@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class, qualifiers = "w400dp-h860dp-xhdpi")
class WearerScreensTest {
    @get:Rule val rule = createEmptyComposeRule()

    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val container get() = app.container
    private val settings get() = container.settings.settings
    private val scope = CoroutineScope(Dispatchers.Main)
    private lateinit var activity: ActivityScenario<MainActivity>

    private fun launch(change: (Settings) -> Settings = { it }) {
        settings.value = change(settings.value)
        activity = ActivityScenario.launch(MainActivity::class.java)
        rule.waitForIdle()
        if (firstScreen(settings.value) == Route.Live) awaitText("Start")
    }

    private fun settle(millis: Long = 1_000) {
        repeat(10) {
            ShadowLooper.idleMainLooper(millis / 10, TimeUnit.MILLISECONDS)
            Thread.sleep(2)
        }
        rule.waitForIdle()
    }

    /** Files are read on threads of their own; only real time brings them. */
    private fun await(what: String, condition: () -> Boolean) {
        repeat(500) {
            if (condition()) return
            settle(20)
        }
        throw AssertionError("never came: $what")
    }

    private fun awaitText(text: String) =
        await(text) { rule.onAllNodes(hasText(text)).fetchSemanticsNodes().isNotEmpty() || scrollTo(text) }

    private fun press(vararg texts: String) = texts.forEach { text ->
        awaitText(text)
        scrollTo(text)
        rule.onNodeWithText(text).performClick()
        settle()
    }

    private fun scrollTo(text: String) =
        runCatching { rule.onNode(hasScrollAction()).performScrollToNode(hasText(text)) }.isSuccess

    private fun assertOn(title: String) = rule.onNode(hasText(title) and isHeading()).assertIsDisplayed()

    /** Guidance on, with a belt that says nothing. */
    private fun guide() {
        val laboratory = runBlocking { container.buildings.find("torgersen-lab")!! }
        scope.launch {
            container.guide.run(container.navigator.state, container.navigator.events, container.settings.settings)
        }
        scope.launch { container.lookout.run(container.navigator.state, container.settings.settings) }
        scope.launch { container.navigator.run(laboratory, Start(), container.belt, container.motion) }
        settle()
    }

    private val isLiveRegion = SemanticsMatcher.keyIsDefined(SemanticsProperties.LiveRegion)

    private val leading get() = (container.navigator.state.value as NavigationState.Running).leading

    private fun heard(words: String) {
        settle(60_000)
        assertTrue("${container.voice.words}", container.voice.words.any { words in it })
    }

    @After fun close() {
        scope.cancel()
        activity.close()
    }

    @Test fun theFirstRunExplainsItselfByVoiceAndAsksForNothingBeforeItSaidWhy() {
        launch { it.copy(introduced = false, building = null, source = SourceKind.USB) }
        assertOn("What the belt is")
        heard("Welcome to Echoway.")
        heard("fifteen small sensors")
        press("Next")
        assertOn("Which way is front")
        heard("The first sensor of the belt is the front")
        press("Next")
        assertOn("A practice walk")
        heard("First the phone asks for two permissions.")
        activity.onActivity { assertNull("nothing was asked yet", shadowOf(it).lastRequestedPermission) }
        press("Start the practice walk")
        await("introduced") { settings.value.introduced }
        activity.onActivity { assertNotNull(shadowOf(it).lastRequestedPermission) }
        assertEquals("torgersen-lab", settings.value.building)
        assertEquals(SourceKind.SIMULATED_WALK, settings.value.source)
    }

    @Test fun withThePermissionsThePracticeWalkStarts() {
        shadowOf(app).grantPermissions(Manifest.permission.POST_NOTIFICATIONS, Manifest.permission.ACTIVITY_RECOGNITION)
        launch { it.copy(introduced = false) }
        press("Next", "Next", "Start the practice walk")
        await("introduced") { settings.value.introduced }
        assertEquals(NavigationService.ACTION_START, shadowOf(app).nextStartedService?.action)
    }

    @Test fun theFirstRunCanBeHeardAgainTurnedBackAndSkipped() {
        launch { it.copy(introduced = false) }
        press("Next")
        settle(60_000)
        press("Say it again")
        settle(60_000)
        assertEquals(2, container.voice.words.count { "The first sensor of the belt is the front" in it })
        press("Back")
        assertOn("What the belt is")
        press("Skip")
        assertTrue(settings.value.introduced)
        awaitText("Start")
        settle(5_000)
        assertTrue("the voice stops with it", !container.voice.heard.last().whole)
    }

    @Test fun theFirstRunThatIsLeftByBackFallsSilent() {
        launch()
        press("Menu", "Introduction")
        settle(1_000)
        Espresso.pressBack()
        settle(2_000)
        assertTrue("${container.voice.heard}", !container.voice.heard.single().whole)
    }

    @Test fun aScreenReaderSpeaksFirst() {
        shadowOf(app.getSystemService(AccessibilityManager::class.java)).setTouchExplorationEnabled(true)
        val before = container.clock.nowS()
        launch { it.copy(introduced = false) }
        heard("Welcome to Echoway.")
        assertTrue(container.voice.heard.first().timeS - before >= 2.5)
    }

    @Test fun whoWasIntroducedIsNotAgain() {
        launch()
        rule.onNodeWithText("Menu").assertIsDisplayed()
    }

    @Test fun aDestinationIsChosenAndLeft() {
        launch()
        guide()
        press("Menu", "Where to?")
        rule.onNodeWithText("Choose where to go.").assertIsDisplayed()
        rule.onNodeWithText("Stop leading me").assertIsNotEnabled()
        press("Lectern, in Room 4, Seminar room")
        val plan = (container.navigator.state.value as NavigationState.Running).building.plan
        assertEquals(
            Wish.LeadTo(Destination(DestinationKind.PLACE, plan.places.indexOfFirst { it.name == "Lectern" })), leading,
        )
        press("Room 5, Media room")
        assertEquals(DestinationKind.ROOM, (leading as Wish.LeadTo).destination.kind)
        rule.onNode(hasScrollAction()).performScrollToNode(hasText("Way out"))
        press("Way out")
        assertEquals(Wish.LeadTo(Destination.WAY_OUT), leading)
        // No belt is heard, so the voice knows no way yet: the screen reader says what was chosen.
        rule.onNode(hasText("Leading you to", substring = true)).assert(isLiveRegion)
        press("Stop leading me")
        assertEquals(null, leading)
        rule.onNodeWithText("Choose where to go.").assert(!isLiveRegion)
        heard("No longer leading you.")
        press("Back the way I came")
        heard("No way back yet.")
    }

    @Test fun whoIsElsewhereSaysWhereAndKeepsTheirDestination() {
        launch()
        guide()
        press("Menu", "Where to?", "Lectern, in Room 4, Seminar room")
        val led = leading
        Espresso.pressBack()
        settle()
        press("I am here")
        rule.onNode(hasText("Exits") and isHeading()).assertIsDisplayed()
        press("Room 5, Media room")
        heard("Starting again: Room 5, Media room.")
        val state = container.navigator.state.value as NavigationState.Running
        assertEquals("5", state.building.plan.rooms[state.estimate.room].id)
        assertEquals(led, leading)
        rule.onNode(hasScrollAction()).performScrollToNode(hasText("I do not know where"))
        press("I do not know where")
        heard("Starting again.")
    }

    @Test fun whereOneStandsCannotBeSaidWhileGuidanceIsOff() {
        launch()
        press("Menu", "I am here")
        rule.onNodeWithText("Start guidance first.").assertIsDisplayed()
    }

    @Test fun theEntranceThatIsNotKnownIsReadInTheChosenLanguage() {
        launch()
        settings.value = settings.value.copy(language = Language.FRENCH)
        press("Menu", "Configuration")
        awaitText("Je ne sais pas")
    }

    @Test fun everySignalIsFeltAndNamed() {
        launch()
        press("Menu", "Practise the vibrations", "Left")
        assertEquals(listOf(Touch.LEFT), container.buzzer.felt)
        heard("Left: Long, short.")
        press("Not sure where you are")
        assertEquals(Touch.UNSURE, container.buzzer.felt.last())
        heard("Not sure where you are: One very long, soft.")
    }

    @Test fun firefighterModeStaysUntilItIsLeft() {
        launch { it.copy(notMovedAlertS = 600) }
        guide()
        press("Menu", "Firefighter mode")
        assertTrue(settings.value.firefighter)
        heard("No certified PASS device.")
        press("Nearest exit")
        assertEquals(Wish.LeadTo(Destination.WAY_OUT), leading)
        press("Leave firefighter mode")
        assertTrue(!settings.value.firefighter)
        rule.onNodeWithText("Menu").assertIsDisplayed()
        heard("Firefighter mode off.")
    }

    @Test fun aFirefighterWhosePhoneCannotSpeakReadsSoAndWhatWouldHaveBeenSaid() {
        launch { it.copy(firefighter = true, notMovedAlertS = 600) }
        guide()
        container.voice.status.value = VoiceStatus.NO_ENGINE
        awaitText("No voice: tones and vibration.")
        rule.onNodeWithText("No voice: tones and vibration.").assertIsDisplayed().assert(isLiveRegion)
        press("Way back")
        awaitText("No way back yet.")
        container.voice.status.value = VoiceStatus.READY
        settle()
        rule.onNodeWithText("No voice: tones and vibration.").assertDoesNotExist()
    }

    @Test fun goingBackLeavesFirefighterModeToo() {
        launch()
        press("Menu", "Firefighter mode")
        Espresso.pressBack()
        settle()
        assertTrue(!settings.value.firefighter)
        assertOn("Menu")
    }

    @Test fun firefighterModeIsLeftThoughThePhoneIsSlowToWriteItDown() {
        launch()
        press("Menu", "Firefighter mode")
        container.settings.slowMs = 2_000
        press("Leave firefighter mode")
        settle(5_000)
        assertTrue(!settings.value.firefighter)
    }

    @Test fun firefighterModeThatTheAppBeganWithIsLeftForTheLiveScreen() {
        launch { it.copy(firefighter = true, notMovedAlertS = 0) }
        press("Leave firefighter mode")
        assertTrue(!settings.value.firefighter)
        awaitText("Menu")
    }

    @Test fun theAlarmFillsTheScreenAndIsCancelledThere() {
        launch { it.copy(firefighter = true, notMovedAlertS = 30) }
        assertOn("Firefighter mode")
        guide()
        settle(40_000)
        assertEquals(Stillness.ALARM, container.lookout.stillness.value)
        assertTrue(container.siren.sounding)
        rule.onNodeWithText("Alarm. Wearer not moving.").assertIsDisplayed()
        assertEquals(Touch.MOVE_NOW, container.buzzer.felt.last())
        press("Cancel alarm")
        assertEquals(Stillness.MOVING, container.lookout.stillness.value)
        assertTrue(!container.siren.sounding)
        rule.onNodeWithText("Nearest exit").assertIsDisplayed()
    }

    @Test fun bothVolumeKeysAskWhileTheAppIsShownUnlessSwitchedOff() {
        launch()
        chord()
        settle(5_000)
        assertEquals(listOf("Guidance is off."), container.voice.words)
        settings.value = settings.value.copy(volumeKeys = false)
        settle()
        chord()
        settle(20_000)
        assertEquals(listOf("Guidance is off."), container.voice.words)
    }

    private fun chord() = activity.onActivity { shown ->
        val keys = listOf(KeyEvent.KEYCODE_VOLUME_UP, KeyEvent.KEYCODE_VOLUME_DOWN)
        keys.forEach { shown.dispatchKeyEvent(KeyEvent(0, 100, KeyEvent.ACTION_DOWN, it, 0)) }
        keys.forEach { shown.dispatchKeyEvent(KeyEvent(0, 300, KeyEvent.ACTION_UP, it, 0)) }
    }
}
