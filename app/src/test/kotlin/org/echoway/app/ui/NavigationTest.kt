package org.echoway.app.ui

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.SemanticsNodeInteraction
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.hasClickAction
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.isHeading
import androidx.compose.ui.test.junit4.v2.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.test.core.app.ApplicationProvider
import androidx.test.espresso.Espresso
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.MainActivity
import org.echoway.app.service.TestApp
import org.echoway.app.settings.ThemeChoice
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** From screen to screen and back, in the real activity. */
@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class, qualifiers = "w400dp-h860dp-xhdpi")
class NavigationTest {
    @get:Rule val rule = createAndroidComposeRule<MainActivity>()

    private val settings get() = ApplicationProvider.getApplicationContext<TestApp>().container.settings.settings

    private fun open(vararg titles: String) = titles.forEach { title ->
        rule.waitUntil(WAIT_MS) { rule.onAllNodes(hasText(title)).fetchSemanticsNodes().isNotEmpty() }
        rule.onNodeWithText(title).performScrollToIfNeeded().performClick()
    }

    private fun SemanticsNodeInteraction.performScrollToIfNeeded() = apply {
        runCatching { performScrollTo() } // what stands outside a list needs no scrolling
    }

    private fun assertOn(title: String) = rule.onNode(hasText(title) and isHeading()).assertIsDisplayed()

    @Test fun everyEntryOfTheMenuOpensAScreenAndBackLeadsToTheMenu() {
        open("Menu")
        val entries = rule.onAllNodes(hasClickAction()).fetchSemanticsNodes()
            .map { it.config[SemanticsProperties.Text].first().text } - "Back"
        assertTrue("$entries", entries.size >= 2)
        for (entry in entries) {
            open(entry)
            rule.waitForIdle()
            Espresso.pressBack()
            rule.waitForIdle()
            assertOn("Menu")
        }
    }

    @Test fun aSettingHoldsAtOnce() {
        open("Menu", "Settings", "High contrast", "Only when asked", "Vibrate")
        rule.waitForIdle()
        assertEquals(ThemeChoice.HIGH_CONTRAST, settings.value.theme)
        assertEquals(false, settings.value.vibration)
    }

    @Test fun theLanguageChangesWhileTheScreenIsShown() {
        open("Menu", "Settings", "Deutsch")
        rule.waitForIdle()
        rule.onNodeWithText("Sprache").assertExists()
        rule.onNodeWithText("Nur auf Nachfrage").assertExists()
    }

    private companion object {
        const val WAIT_MS = 5_000L
    }
}
