package org.echoway.app.ui.common

import android.content.res.Resources
import kotlin.math.roundToInt
import org.echoway.app.R
import org.echoway.core.LengthStyle

/** A measured length to one decimal, in the wearer's unit. Steps are too coarse for what a sensor measures. */
fun Resources.length(metres: Double, style: LengthStyle): String = when (style) {
    LengthStyle.METRES -> getString(R.string.length_metres, metres)
    LengthStyle.FEET, LengthStyle.STEPS -> getString(R.string.length_feet, metres / METRES_PER_FOOT)
}

private const val METRES_PER_FOOT = 0.3048

/** A length that is only roughly known, in whole units, or in fives above ten. */
fun Resources.roughLength(metres: Double, style: LengthStyle): String {
    val (unit, name) = when (style) {
        LengthStyle.METRES -> 1.0 to R.plurals.rough_metres
        LengthStyle.FEET -> METRES_PER_FOOT to R.plurals.rough_feet
        LengthStyle.STEPS -> METRES_PER_STEP to R.plurals.rough_steps
    }
    val exact = metres / unit
    val count = if (exact < FINE_BELOW) exact.roundToInt().coerceAtLeast(1) else (exact / COARSE).roundToInt() * COARSE
    return getQuantityString(name, count, count)
}

private const val METRES_PER_STEP = 0.7
private const val FINE_BELOW = 9.5
private const val COARSE = 5
