package org.echoway.app.core

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import kotlinx.coroutines.runBlocking
import org.echoway.app.belt.WireSentence
import org.echoway.app.building.BundledBuildings
import org.echoway.app.building.InstalledBuilding
import org.echoway.core.BeltLink
import org.echoway.core.BeltSetup
import org.echoway.core.CoreException
import org.echoway.core.CoreSession
import org.echoway.core.MotionHint
import org.echoway.core.MotionKind
import org.echoway.core.PlanLoader
import org.echoway.core.Point
import org.echoway.core.RoomName
import org.echoway.core.Start
import org.echoway.core.TrackState
import org.junit.Assert.assertEquals
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** The core through JNI, on the host and on devices. */
@RunWith(AndroidJUnit4::class)
class CoreBindingTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val laboratory: InstalledBuilding = runBlocking { BundledBuildings(context, 1).find("torgersen-lab")!! }
    private val seminarRoom = laboratory.plan.rooms.indexOfFirst { it.id == "4" }

    @Test fun readsThePlanWithRoomsDoorsAndNames() {
        val plan = laboratory.plan
        assertEquals("Torgersen laboratory", plan.name)
        assertEquals("Seminar room", plan.rooms[seminarRoom].name)
        assertEquals(RoomName("4", "Seminar room"), plan.rooms[seminarRoom].aloud)
        assertEquals(RoomName("", "Hall"), plan.rooms.single { it.id == "hall" }.aloud)
        assertTrue(plan.rooms.all { it.walls.size >= 4 && it.boundary.isNotEmpty() })
        val corridor = plan.rooms.indexOfFirst { it.id == "2" }
        val door = plan.doors.single { it.seenFrom(seminarRoom) != null && it.seenFrom(corridor) != null }
        val fromHere = plan.rooms[seminarRoom].frame.toLevel(door.seenFrom(seminarRoom)!!)
        val fromThere = plan.rooms[corridor].frame.toLevel(door.seenFrom(corridor)!!)
        assertEquals("a door is one place, whichever room it is seen from", 0.0, fromHere.distanceTo(fromThere), 0.01)
        assertTrue(plan.places.any { it.name == "Lectern" && it.spot.room == seminarRoom })
    }

    @Test fun anUnusableBuildingIsRefusedWithFileAndLine() {
        val folder = File(context.cacheDir, "broken-\u00fc\u4e16").apply { mkdirs() }
        File(folder, "room-1.room").writeText("four walls\n")
        val error = assertThrows(CoreException::class.java) { PlanLoader.load(folder) }
        assertTrue(error.message, error.message!!.contains("broken-\u00fc\u4e16/room-1.room:1:"))
        assertThrows(CoreException::class.java) { CoreSession.open(folder, 0.0) }
    }

    @Test fun aBeltThatCannotBeIsRefused() {
        val impossible = listOf(
            BeltSetup(sensors = 0),
            BeltSetup(radiusM = -1.0),
            BeltSetup(beamRad = 0.0),
            BeltSetup(slotS = -1.0),
            BeltSetup(temperatureC = -300.0),
        )
        for (belt in impossible) {
            assertThrows("$belt", CoreException::class.java) { CoreSession.open(laboratory.folder, 0.0, belt = belt) }
        }
        val cold = BeltSetup(12, 0.2, Math.toRadians(30.0), 0.1, -5.0)
        CoreSession.open(laboratory.folder, 0.0, belt = cold).use { assertEquals(12, it.beltHealth.sensors.size) }
    }

    @Test fun aStartInARoomIsWhereTheEstimateBegins() {
        CoreSession.open(laboratory.folder, 0.0, Start(seminarRoom, Point(2.0, 1.0), 0.5)).use { session ->
            val estimate = session.estimate
            assertEquals(seminarRoom, estimate.room)
            assertEquals(2.0, estimate.x, 0.3)
            assertEquals(1.0, estimate.y, 0.3)
            assertEquals(BeltLink.ABSENT, session.beltHealth.link)
        }
    }

    @Test fun aRoomThatDoesNotExistIsRefused() {
        assertThrows(CoreException::class.java) { CoreSession.open(laboratory.folder, 0.0, Start(room = 99)) }
        CoreSession.open(laboratory.folder, 0.0).use { session ->
            assertThrows(CoreException::class.java) { session.restart(Start(room = 99)) }
            session.restart(Start(room = seminarRoom))
            assertEquals(seminarRoom, session.estimate.room)
        }
    }

    @Test fun aPlaceFarOutsideItsRoomIsRefusedAndTheRoomIsDescribed() {
        val outside = Start(seminarRoom, Point(-5.0, 1.0), 0.0)
        val refused = assertThrows(CoreException::class.java) { CoreSession.open(laboratory.folder, 0.0, outside) }
        assertTrue(
            refused.message,
            "(-5, 1) lies 5 m outside room 4, whose floor is between (0, 0) and (" in refused.message.orEmpty(),
        )
        CoreSession.open(laboratory.folder, 0.0, Start(room = seminarRoom)).use { session ->
            assertEquals(refused.message, assertThrows(CoreException::class.java) { session.restart(outside) }.message)
        }
    }

    @Test fun bytesBecomeFiringsHoweverTheyAreCut() {
        CoreSession.open(laboratory.folder, 0.0).use { session ->
            session.onBeltAttached(0.0)
            val sentence = WireSentence.range(7, 3, 1.5)
            assertEquals(0, session.onBytes(sentence.copyOfRange(0, 9), 0.1))
            assertEquals(1, session.onBytes(sentence.copyOfRange(9, sentence.size), 0.2))
            assertEquals(0, session.onBytes("\$EWR,8,3,1500*0000\r\n".toByteArray(), 0.3))
            val health = session.beltHealth
            assertEquals(BeltLink.CONNECTED, health.link)
            assertEquals(1L, health.goodSentences)
            assertEquals(1L, health.badChecksums)
            assertEquals(1.5, health.sensors[3].lastRangeM!!, 1e-9)
        }
    }

    @Test fun noiseNeitherCrashesNorCounts() {
        CoreSession.open(laboratory.folder, 0.0).use { session ->
            val noise = ByteArray(100_000) { (it * 31 xor (it shr 3)).toByte() }
            assertEquals(0, session.onBytes(noise, 1.0))
            session.onMotion(MotionHint(Double.NaN, MotionKind.STEP, Double.POSITIVE_INFINITY))
            session.onTick(Double.NaN)
            assertEquals(TrackState.SEARCHING, session.estimate.state)
            assertTrue(session.estimate.sigmaM.isFinite())
        }
    }

    @Test fun aClosedSessionIsNotUsedAgain() {
        val session = CoreSession.open(laboratory.folder, 0.0)
        session.close()
        session.close()
        assertThrows(IllegalStateException::class.java) { session.onTick(1.0) }
        assertThrows(IllegalStateException::class.java) { session.beltHealth }
    }
}
