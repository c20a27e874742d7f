package org.echoway.app.ui.diagnostics

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.settings.inLanguage
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.Language
import org.echoway.core.SensorHealth
import org.echoway.core.SensorState
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Test
import org.junit.runner.RunWith

@RunWith(AndroidJUnit4::class)
class DiagnosticsReportTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val report = DiagnosticsReport(context.resources)

    private fun sensor(state: SensorState, firings: Int, echoes: Int, fault: Int = 0) =
        SensorHealth(state, firings, echoes, fault, 4.321, 1.0)

    private val belt = BeltHealth(
        BeltLink.CONNECTED, 16.03, goodSentences = 1234, badChecksums = 3, malformed = 1, lostFirings = 12,
        restarts = 1,
        temperatureC = 21.5, batteryV = 7.384, firmware = "1.4",
        sensors = listOf(
            sensor(SensorState.GOOD, 64, 60),
            sensor(SensorState.SILENT, 64, 0),
            sensor(SensorState.FAULT, 1, 1, fault = 2),
        ),
    )

    @Test fun theWholeReportInWords() = assertEquals(
        """
        Echoway 1.0, Android 15, Some phone
        2 of 3 sensors need looking after.
        The belt is connected.
        16.0 firings a second
        Good sentences: 1234
        Dropped sentences: 3 with a wrong checksum, 1 malformed
        Lost firings: 12
        Restarts of the belt: 1
        Temperature: 21.5 °C
        Battery: 7.38 V
        Firmware: 1.4
        1, Front: good. 60 echoes of 64 firings in the last minute.
        2, Back left: silent: covered or dead. 0 echoes of 64 firings in the last minute.
        3, Back right: broken, says the belt. 1 echo of 1 firing in the last minute. Fault code 2.
        """.trimIndent(),
        report.text(belt, "Echoway 1.0, Android 15, Some phone"),
    )

    @Test fun whatTheBeltDoesNotTellIsSaid() {
        val lines = report.belt(BeltHealth.NONE)
        assertEquals("No belt was heard yet.", lines.first())
        assertEquals(
            listOf(
                "The belt does not tell its temperature.",
                "The belt does not tell its battery.",
                "The belt does not tell its firmware.",
            ),
            lines.takeLast(3),
        )
        assertEquals("No sensor was heard yet. Start guidance to hear the belt.", report.summary(BeltHealth.NONE))
    }

    @Test fun noRangeIsInIt() = assertFalse("4.3" in report.text(belt, ""))

    @Test fun inGermanAndFrench() {
        val german = DiagnosticsReport(context.inLanguage(Language.GERMAN).resources)
        assertEquals("2 von 3 Sensoren brauchen Hilfe.", german.summary(belt))
        assertEquals(
            "1 von 3 Sensoren braucht Hilfe.",
            german.summary(belt.copy(sensors = belt.sensors.take(2) + belt.sensors[0])),
        )
        val french = DiagnosticsReport(context.inLanguage(Language.FRENCH).resources)
        assertEquals(
            "1 capteur sur 3 demande une vérification.",
            french.summary(belt.copy(sensors = belt.sensors.take(2) + belt.sensors[0])),
        )
    }
}
