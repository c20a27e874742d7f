package org.echoway.app.belt

import java.io.IOException
import org.echoway.core.BeltSetup
import org.echoway.core.MotionKind
import org.echoway.core.Point
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test

class WalkLogTest {
    private fun read(scans: String, motion: String? = null) =
        WalkLog.read(scans.reader().buffered(), motion?.reader()?.buffered())

    @Test fun readsFiringsAndHints() {
        val log = read(
            "# sensors 3\ntime_s,sensor,range_m\n0.0,0,1.5\n0.06,2,\n",
            "time_s,kind,value\n0.03,step,1\n0.05,yaw_rate_dps,90\n",
        )
        assertEquals(BeltSetup(sensors = 3), log.belt)
        assertEquals(1.5, log.firings[0].rangeM!!, 0.0)
        assertNull(log.firings[1].rangeM)
        assertEquals(MotionKind.STEP, log.hints[0].kind)
        assertEquals(Math.PI / 2, log.hints[1].value, 1e-12)
    }

    @Test fun readsWhatBeltItWas() {
        val head = "# belt of oak\n# sensors 12\n#radius_m\t0.2\n# beam_deg 30\n# slot_s 0.1\n# temperature_c -5\n"
        val log = read("${head}time_s,sensor,range_m\n0.0,11,1.5\n# sensors 4\n")
        assertEquals(BeltSetup(12, 0.2, Math.toRadians(30.0), 0.1, -5.0), log.belt)
    }

    @Test fun refusesABeltThatCannotBe() {
        val senseless = listOf(
            "sensors 0", "sensors 65", "sensors 1.5", "radius_m -1", "beam_deg wide", "slot_s 0", "temperature_c NaN",
        )
        for (line in senseless) {
            val error = assertThrows(IOException::class.java) { read("# $line\ntime_s,sensor,range_m\n0.0,0,1.5\n") }
            assertTrue(error.message, error.message!!.startsWith("line 1: # $line"))
        }
    }

    @Test fun readsWhereTheWearerSaidThatTheyStand() {
        val log = read(
            "# restart the belt\ntime_s,sensor,range_m\n0.0,0,1.5\n# restart 0.03 hall 1.5 2 90\n" +
                "0.06,2,\n# restart 0.07 - - - -\n",
        )
        assertEquals(
            listOf(LoggedRestart(0.03, "hall", Point(1.5, 2.0), Math.PI / 2), LoggedRestart(0.07, null, null, null)),
            log.restarts,
        )
        val error = assertThrows(IOException::class.java) {
            read("time_s,sensor,range_m\n0.0,0,1.5\n# restart now hall 1 2 3\n")
        }
        assertTrue(error.message, error.message!!.startsWith("line 3: # restart now"))
    }

    @Test fun aLogMayComeFromAnySystem() {
        val log = read("\uFEFF# sensors 3\r\ntime_s, sensor, range_m, note\r\n0.0, 0, 1.5, a\r\n0.06, 2, , b\r\n")
        assertEquals(3, log.belt.sensors)
        assertEquals(listOf(LoggedFiring(0.0, 0, 1.5), LoggedFiring(0.06, 2, null)), log.firings)
    }

    @Test fun refusesAnotherKindOfLogAndTimeThatGoesBack() {
        for (text in listOf("0.0,0,1.5\n0.06,1,1.5\n", "time_s,kind,value\n0.0,step,1\n")) {
            val error = assertThrows(IOException::class.java) { read(text) }
            assertTrue(
                error.message, "line 1: " in error.message!! && "must be 'time_s,sensor,range_m'" in error.message!!,
            )
        }
        val error = assertThrows(IOException::class.java) { read("time_s,sensor,range_m\n0.1,0,1.5\n0.0,1,1.5\n") }
        assertTrue(error.message, error.message!!.startsWith("line 3: 0.0,1,1.5: time_s goes back"))
    }

    @Test fun saysWhichLineIsBroken() {
        val error = assertThrows(IOException::class.java) { read("time_s,sensor,range_m\n0.0,0,1.5\n0.06,two,1.0\n") }
        assertTrue(error.message, error.message!!.startsWith("line 3: 0.06,two,1.0"))
    }

    @Test fun refusesWhatIsNoLength() {
        for (range in listOf("NaN", "-1", "1e999", "0x1p3", "1.5f")) {
            val error =
                assertThrows(IOException::class.java) { read("time_s,sensor,range_m\n0.0,0,$range\n0.06,0,1.5\n") }
            assertTrue(error.message, error.message!!.startsWith("line 2: 0.0,0,$range"))
        }
    }

    @Test fun refusesAStepOfAnotherValueThanOne() {
        val error = assertThrows(IOException::class.java) {
            read("time_s,sensor,range_m\n0.0,0,1.5\n", "time_s,kind,value\n0.0,step,1.0\n0.5,step,2\n")
        }
        assertTrue(error.message, error.message!!.startsWith("line 3: 0.5,step,2"))
    }

    @Test fun refusesAnEmptyLogAndAnImpossibleSensor() {
        assertThrows(IOException::class.java) { read("time_s,sensor,range_m\n") }
        assertThrows(IOException::class.java) { read("# sensors 3\ntime_s,sensor,range_m\n0.0,3,1.0\n") }
    }
}
