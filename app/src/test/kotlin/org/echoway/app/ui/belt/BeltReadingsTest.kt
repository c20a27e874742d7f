package org.echoway.app.ui.belt

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.settings.inLanguage
import org.echoway.core.Element
import org.echoway.core.ExplainedEcho
import org.echoway.core.Language
import org.echoway.core.LengthStyle
import org.junit.Assert.assertEquals
import org.junit.Test
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class BeltReadingsTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val feet = BeltReadings(context.resources, LengthStyle.FEET)

    private fun echo(rangeM: Double?, element: Element = Element.NONE, timeS: Double = 1.0) =
        ExplainedEcho(timeS, rangeM, element, null, null)

    private val scan = listOf(echo(3.048, Element.WALL), echo(1.0, Element.NONE), echo(null), echo(null, timeS = -1.0))

    @Test fun eachReadingSaysWhereHowFarAndWhat() = assertEquals(
        listOf(
            "1, Front: 10.0 feet, wall.",
            "2, Left: 3.3 feet, not on the plan.",
            "3, Back: no echo.",
            "4, Right: not heard of.",
        ),
        scan.indices.map { feet.words(it, scan) },
    )

    @Test fun theSummaryIsTheNearestAndHowMuchThePlanExplains() =
        assertEquals(
            "Nearest: 2, Left: 3.3 feet, not on the plan. The plan explains 1 of 2 readings.", feet.summary(scan),
        )

    @Test fun silenceIsSaid() = assertEquals("No sensor hears an echo.", feet.summary(List(15) { echo(null) }))

    @Test fun inMetresAndInGerman() {
        val german = BeltReadings(context.inLanguage(Language.GERMAN).resources, LengthStyle.METRES)
        assertEquals("1,0 Meter, nicht auf dem Plan.", german.words(1, scan).substringAfter(": "))
    }
}
