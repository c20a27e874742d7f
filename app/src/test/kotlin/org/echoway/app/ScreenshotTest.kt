package org.echoway.app

import androidx.compose.ui.test.junit4.v2.createComposeRule
import com.github.takahirom.roborazzi.captureRoboImage
import org.echoway.app.screens.Device
import org.echoway.app.screens.Specimen
import org.echoway.app.screens.Variant
import org.echoway.app.screens.assertAccessible
import org.echoway.app.screens.onTopWindow
import org.echoway.app.screens.specimens
import org.echoway.app.ui.EchowayTheme
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.ParameterizedRobolectricTestRunner
import org.robolectric.ParameterizedRobolectricTestRunner.Parameters

/**
 * Every screen in every variant against its golden picture in `app/screenshots/` and against the accessibility checks;
 * `make screenshots` draws the pictures anew.
 */
@RunWith(ParameterizedRobolectricTestRunner::class)
class ScreenshotTest(private val specimen: Specimen, private val variant: Variant) {
    @get:Rule(order = 0)
    val device = Device(variant)

    @get:Rule(order = 1)
    val rule = createComposeRule()

    @Test fun looksAsItShouldAndCanBeUsedByEverybody() {
        rule.setContent { EchowayTheme(variant.theme, specimen.screen) }
        if (variant in specimen.variants) {
            rule.onTopWindow().captureRoboImage("$FOLDER/${specimen.name}${variant.suffix}.png")
        }
        rule.assertAccessible()
    }

    companion object {
        private val FOLDER = System.getProperty("echoway.root")!! + "/app/screenshots"

        @JvmStatic
        @Parameters(name = "{0} {1}")
        fun all(): List<Array<Any>> = specimens().flatMap { specimen -> Variant.entries.map { arrayOf(specimen, it) } }
    }
}
