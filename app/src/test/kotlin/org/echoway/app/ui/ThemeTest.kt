package org.echoway.app.ui

import androidx.compose.material3.ColorScheme
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.luminance
import org.echoway.app.settings.ThemeChoice
import org.junit.Assert.assertEquals
import org.junit.Test

/** What is read stands out by 7:1 (WCAG AAA), what is drawn by 4.5:1 where 3:1 would do. */
class ThemeTest {
    private fun contrast(a: Color, b: Color): Double {
        val (dark, light) = listOf(a.luminance(), b.luminance()).sorted()
        return (light + 0.05) / (dark + 0.05)
    }

    private fun read(c: ColorScheme) = mapOf(
        "text" to (c.onSurface to c.surface),
        "text on the background" to (c.onBackground to c.background),
        "lesser text" to (c.onSurfaceVariant to c.surface),
        "text on a panel" to (c.onSurface to c.surfaceVariant),
        "lesser text on a panel" to (c.onSurfaceVariant to c.surfaceVariant),
        "button" to (c.onPrimary to c.primary),
        "outlined button" to (c.primary to c.surface),
        "chosen" to (c.onPrimaryContainer to c.primaryContainer),
        "chosen too" to (c.onSecondaryContainer to c.secondaryContainer),
        "failure" to (c.error to c.surface),
        "dialog" to (c.onSurface to c.surfaceContainerHigh),
        "button of a dialog" to (c.primary to c.surfaceContainerHigh),
    )

    private fun drawn(c: ColorScheme) = mapOf(
        "outline" to (c.outline to c.surface),
        "outline on a panel" to (c.outline to c.surfaceVariant),
        "way" to (c.tertiary to c.surface),
        "way on a panel" to (c.tertiary to c.surfaceVariant),
        "way where the wearer is" to (c.tertiary to c.primaryContainer),
        "wearer" to (c.primary to c.surfaceVariant),
        "wearer where they are" to (c.primary to c.primaryContainer),
        "switch that is off" to (c.outline to c.surfaceContainerHighest),
    )

    private fun tooFaint(pairs: Map<String, Pair<Color, Color>>, least: Double) =
        pairs.mapValues { (_, pair) -> contrast(pair.first, pair.second) }.filterValues { it < least }

    @Test fun everythingStandsOutInEveryTheme() {
        for (choice in ThemeChoice.entries) {
            for (dark in listOf(false, true)) {
                val scheme = colours(choice, dark)
                assertEquals(
                    "$choice dark=$dark",
                    emptyMap<String, Double>(),
                    tooFaint(read(scheme), 7.0) + tooFaint(drawn(scheme), 4.5),
                )
            }
        }
    }
}
