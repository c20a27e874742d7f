package org.echoway.app.ui

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.graphics.Color

/** Blue on near-black or near-white: contrast of text and marks is 7:1 or better, and no hue carries meaning alone. */
private val Light = lightColorScheme(
    primary = Color(0xFF0B4A8F),
    onPrimary = Color.White,
    primaryContainer = Color(0xFFCFE2FF),
    onPrimaryContainer = Color(0xFF001B3D),
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

@Composable
fun EchowayTheme(dark: Boolean = isSystemInDarkTheme(), content: @Composable () -> Unit) {
    MaterialTheme(colorScheme = if (dark) Dark else Light, content = content)
}
