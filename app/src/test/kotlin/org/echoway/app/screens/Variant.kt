package org.echoway.app.screens

import org.echoway.app.settings.ThemeChoice
import org.junit.rules.ExternalResource
import org.robolectric.RuntimeEnvironment

/** A way in which a screen may be shown. Pictures are small; the first is what the documentation shows. */
enum class Variant(val suffix: String, val qualifiers: String, val theme: ThemeChoice, val fontScale: Float = 1f) {
    LIGHT("", "$PHONE-hdpi", ThemeChoice.LIGHT),
    DARK("-dark", "$PHONE-mdpi", ThemeChoice.DARK),
    HIGH_CONTRAST("-high-contrast", "$PHONE-mdpi", ThemeChoice.HIGH_CONTRAST),
    SMOKE("-smoke", "$PHONE-mdpi", ThemeChoice.SMOKE),
    LARGE_TEXT("-large-text", "$PHONE-mdpi", ThemeChoice.LIGHT, fontScale = 2f),
    GERMAN_LARGE_TEXT("-german-large-text", "de-$PHONE-mdpi", ThemeChoice.LIGHT, fontScale = 2f),
    LANDSCAPE("-landscape", "$LYING_PHONE-mdpi", ThemeChoice.LIGHT),
    LANDSCAPE_LARGE_TEXT("-landscape-large-text", "$LYING_PHONE-mdpi", ThemeChoice.LIGHT, fontScale = 2f),
    TABLET("-tablet", "w1024dp-h768dp-land-hdpi", ThemeChoice.LIGHT),
}

private const val PHONE = "w400dp-h860dp"
private const val LYING_PHONE = "w860dp-h400dp-land"

/** Makes the device one that shows a variant; must come before the rule that opens the screen. */
class Device(private val variant: Variant) : ExternalResource() {
    override fun before() {
        RuntimeEnvironment.setQualifiers("+${variant.qualifiers}")
        RuntimeEnvironment.setFontScale(variant.fontScale)
    }
}
