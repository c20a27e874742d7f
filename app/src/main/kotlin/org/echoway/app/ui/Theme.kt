package org.echoway.app.ui

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.ColorScheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.graphics.Color
import org.echoway.app.settings.ThemeChoice

/**
 * Blue on near-black or near-white: contrast of text is 7:1 or better, of marks 4.5:1, and no hue
 * carries meaning alone.
 */
private val Light = lightColorScheme(
    primary = Color(0xFF0B4A8F),
    onPrimary = Color.White,
    primaryContainer = Color(0xFFCFE2FF),
    onPrimaryContainer = Color(0xFF001B3D),
    secondaryContainer = Color(0xFFCFE2FF),
    onSecondaryContainer = Color(0xFF001B3D),
    tertiary = Color(0xFFA33B00),
    background = Color(0xFFFCFCFF),
    surface = Color(0xFFFCFCFF),
    onSurface = Color(0xFF111418),
    surfaceVariant = Color(0xFFE7EBF1),
    onSurfaceVariant = Color(0xFF2B3036),
    outline = Color(0xFF4A5058),
    outlineVariant = Color(0xFF4A5058),
    error = Color(0xFF8C0009),
)

private val Dark = darkColorScheme(
    primary = Color(0xFFA8CBFF),
    onPrimary = Color(0xFF00254D),
    primaryContainer = Color(0xFF0A3A70),
    onPrimaryContainer = Color(0xFFD6E6FF),
    secondaryContainer = Color(0xFF0A3A70),
    onSecondaryContainer = Color(0xFFD6E6FF),
    tertiary = Color(0xFFFFB68C),
    background = Color(0xFF0B0D10),
    surface = Color(0xFF0B0D10),
    onSurface = Color(0xFFF2F4F8),
    surfaceVariant = Color(0xFF23282F),
    onSurfaceVariant = Color(0xFFD9DEE6),
    outline = Color(0xFFB4BAC4),
    outlineVariant = Color(0xFFB4BAC4),
    error = Color(0xFFFFB4AB),
)

/** Black, white and one yellow: 21:1 for text, and marks that need no shade to be told apart. */
private val HighContrast = darkColorScheme(
    primary = Color(0xFFFFEB3B),
    onPrimary = Color.Black,
    primaryContainer = Color(0xFF4A4200),
    onPrimaryContainer = Color.White,
    secondaryContainer = Color(0xFF4A4200),
    onSecondaryContainer = Color.White,
    tertiary = Color(0xFF00E5FF),
    background = Color.Black,
    onBackground = Color.White,
    surface = Color.Black,
    onSurface = Color.White,
    surfaceVariant = Color(0xFF1A1A1A),
    onSurfaceVariant = Color.White,
    outline = Color.White,
    outlineVariant = Color.White,
    error = Color(0xFFFFB4AB),
    onError = Color.Black,
)

/** Amber on black: smoke throws blue light back at the reader, and white light most of it. */
private val Smoke = darkColorScheme(
    primary = Color(0xFFFFB300),
    onPrimary = Color.Black,
    primaryContainer = Color(0xFF4D3300),
    onPrimaryContainer = Color(0xFFFFD27A),
    secondaryContainer = Color(0xFF4D3300),
    onSecondaryContainer = Color(0xFFFFD27A),
    tertiary = Color(0xFFFF7A5C),
    background = Color.Black,
    onBackground = Color(0xFFFFC14D),
    surface = Color.Black,
    onSurface = Color(0xFFFFC14D),
    surfaceVariant = Color(0xFF1F1500),
    onSurfaceVariant = Color(0xFFFFC14D),
    outline = Color(0xFFFFB300),
    outlineVariant = Color(0xFFFFB300),
    error = Color(0xFFFF8A80),
    onError = Color.Black,
)

/** @param dark whether the phone's own theme is */
internal fun colours(theme: ThemeChoice, dark: Boolean): ColorScheme = when (theme) {
    ThemeChoice.SYSTEM -> if (dark) Dark else Light
    ThemeChoice.LIGHT -> Light
    ThemeChoice.DARK -> Dark
    ThemeChoice.HIGH_CONTRAST -> HighContrast
    ThemeChoice.SMOKE -> Smoke
}

@Composable
fun EchowayTheme(theme: ThemeChoice = ThemeChoice.SYSTEM, content: @Composable () -> Unit) {
    MaterialTheme(colorScheme = colours(theme, isSystemInDarkTheme()), content = content)
}
