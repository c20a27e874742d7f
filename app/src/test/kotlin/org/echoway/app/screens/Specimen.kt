package org.echoway.app.screens

import androidx.compose.runtime.Composable

/**
 * A screen in one of its states, for pictures and accessibility checks.
 *
 * @property variants in which it is drawn; accessibility is checked in all of them whatever is drawn
 */
class Specimen(val name: String, val variants: Set<Variant> = USUAL, val screen: @Composable () -> Unit) {
    override fun toString() = name
}

/** Every variant is checked; these are drawn of most screens. */
val USUAL = setOf(Variant.LIGHT, Variant.DARK, Variant.HIGH_CONTRAST, Variant.LARGE_TEXT, Variant.TABLET)

/** For states that differ from another specimen by a few words. */
val LIGHT_ONLY = setOf(Variant.LIGHT)
