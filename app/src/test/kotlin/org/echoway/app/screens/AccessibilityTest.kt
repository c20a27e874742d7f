package org.echoway.app.screens

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.size
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.test.junit4.v2.createComposeRule
import androidx.compose.ui.unit.dp
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** The accessibility checks find what they are there for. */
@RunWith(AndroidJUnit4::class)
@Config(qualifiers = "w400dp-h860dp-mdpi")
class AccessibilityTest {
    @get:Rule val rule = createComposeRule()

    private fun assertFound(problem: String, content: @Composable () -> Unit) {
        rule.setContent {
            Column(Modifier.background(Color.White)) {
                Text("Title", Modifier.semantics { heading() })
                content()
            }
        }
        val error = assertThrows(AssertionError::class.java) { rule.assertAccessible() }
        assertTrue(error.message, problem in error.message!!)
    }

    @Test fun somethingWithoutAName() =
        assertFound("SpeakableTextPresentCheck") { Box(Modifier.size(60.dp).clickable {}) }

    @Test fun aTargetThatIsTooSmall() =
        assertFound("TouchTargetSizeCheck") { Box(Modifier.size(30.dp).clickable {}) { Text("A") } }

    @Test fun textThatDoesNotStandOut() =
        assertFound("TextContrastCheck") { Text("Hardly to be read", color = Color(0xFFBBBBBB)) }

    @Test fun textThatIsCut() = assertFound("text overflows") { Text("Half of this", Modifier.height(8.dp)) }

    @Test fun somethingBeforeTheHeading() {
        rule.setContent { Text("No heading") }
        assertThrows(AssertionError::class.java) { rule.assertAccessible() }
    }
}
