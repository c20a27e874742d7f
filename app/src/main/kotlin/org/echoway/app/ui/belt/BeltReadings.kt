package org.echoway.app.ui.belt

import android.content.res.Resources
import org.echoway.app.R
import org.echoway.app.guide.Side
import org.echoway.app.ui.common.length
import org.echoway.core.Element
import org.echoway.core.ExplainedEcho
import org.echoway.core.LengthStyle

/** What each sensor hears, in words. */
class BeltReadings(private val resources: Resources, private val lengths: LengthStyle) {
    /** "3, left: 6.2 feet, wall." */
    fun words(index: Int, scan: List<ExplainedEcho>): String {
        val side = resources.getStringArray(R.array.sides)[Side.of(index, scan.size).ordinal]
        return resources.getString(R.string.belt_reading, index + 1, side, reading(scan[index]))
    }

    /** The nearest reading, and how many the plan explains. */
    fun summary(scan: List<ExplainedEcho>): String {
        val heard = scan.withIndex().filter { it.value.rangeM != null }
        val nearest = heard.minByOrNull { it.value.rangeM!! } ?: return resources.getString(R.string.belt_hears_nothing)
        val explained = heard.count { it.value.element != Element.NONE }
        val first = resources.getString(R.string.belt_nearest, words(nearest.index, scan))
        return first + " " + resources.getQuantityString(R.plurals.belt_explained, heard.size, explained, heard.size)
    }

    private fun reading(echo: ExplainedEcho): String {
        val range = echo.rangeM
            ?: return resources.getString(if (echo.timeS < 0) R.string.belt_not_fired else R.string.belt_no_echo)
        val length = resources.length(range, lengths)
        return resources.getString(R.string.belt_range, length, resources.getString(echo.element.words))
    }
}

internal val Element.words
    get() = when (this) {
        Element.NONE -> R.string.element_none
        Element.WALL -> R.string.element_wall
        Element.CORNER -> R.string.element_corner
        Element.EDGE -> R.string.element_edge
        Element.REFLECTOR -> R.string.element_reflector
    }
