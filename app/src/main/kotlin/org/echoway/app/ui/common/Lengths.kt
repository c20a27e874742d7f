package org.echoway.app.ui.common

import android.content.res.Resources
import org.echoway.app.R
import org.echoway.core.LengthStyle

/** A measured length to one decimal, in the wearer's unit. Steps are too coarse for what a sensor measures. */
fun Resources.length(metres: Double, style: LengthStyle): String = when (style) {
    LengthStyle.METRES -> getString(R.string.length_metres, metres)
    LengthStyle.FEET, LengthStyle.STEPS -> getString(R.string.length_feet, metres / METRES_PER_FOOT)
}

private const val METRES_PER_FOOT = 0.3048
