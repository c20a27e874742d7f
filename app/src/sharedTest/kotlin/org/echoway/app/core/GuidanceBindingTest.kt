package org.echoway.app.core

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import kotlin.math.abs
import kotlinx.coroutines.runBlocking
import org.echoway.app.belt.WalkLog
import org.echoway.app.belt.WireSentence
import org.echoway.app.building.BundledBuildings
import org.echoway.app.building.InstalledBuilding
import org.echoway.core.BuildingCheck
import org.echoway.core.CoreException
import org.echoway.core.CoreSession
import org.echoway.core.Cue
import org.echoway.core.CueKind
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.DirectionStyle
import org.echoway.core.Element
import org.echoway.core.LandmarkKind
import org.echoway.core.Language
import org.echoway.core.LengthStyle
import org.echoway.core.Severity
import org.echoway.core.SpeechStyle
import org.echoway.core.Start
import org.echoway.core.Urgency
import org.echoway.core.WaypointKind
import org.echoway.core.destinations
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNotNull
import org.junit.Assert.assertNull
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** Guidance through JNI: cues with their words, ways, breadcrumbs, and what a picture needs. */
@RunWith(AndroidJUnit4::class)
class GuidanceBindingTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val laboratory: InstalledBuilding = runBlocking { BundledBuildings(context, 1).find("torgersen-lab")!! }
    private val plan = laboratory.plan
    private val lectern = Destination(DestinationKind.PLACE, plan.places.indexOfFirst { it.name == "Lectern" })

    private inner class Walk(val session: CoreSession, private val style: SpeechStyle) {
        private val log = WalkLog.read(asset("scans"), asset("motion"))
        private var firing = 0
        private var hint = 0
        val cues = mutableListOf<Cue>()

        fun walkUntil(timeS: Double) {
            while (firing < log.firings.size && log.firings[firing].timeS <= timeS) {
                val next = log.firings[firing]
                while (hint < log.hints.size && log.hints[hint].timeS <= next.timeS) session.onMotion(log.hints[hint++])
                session.onBytes(WireSentence.range(firing++, next.sensor, next.rangeM), next.timeS)
                while (true) cues += session.nextCue(style) ?: break
            }
        }

        private fun asset(kind: String) = context.assets.open("walks/torgersen-lab.$kind.csv").bufferedReader()
    }

    private fun walking(style: SpeechStyle = SpeechStyle(), test: Walk.() -> Unit) {
        val start = Start(plan.rooms.indexOfFirst { it.id == "1" })
        CoreSession.open(laboratory.folder, 0.0, start).use { Walk(it, style).test() }
    }

    @Test fun cuesComeWithTheirWords() = walking {
        walkUntil(20.0)
        assertNull("each cue is taken once", session.nextCue())
        val entered = cues.first { it.kind == CueKind.ENTERING }
        assertEquals(Urgency.PLACE, entered.urgency)
        assertTrue(entered.words, entered.words.startsWith("Room ${plan.rooms[entered.room].id}, "))
        assertTrue(entered.timeToLiveS > 0.0)
        assertNull(entered.distanceM)
        assertNull(entered.direction)
    }

    @Test fun whereAmIIsAnsweredByCues() = walking {
        walkUntil(5.0)
        cues.clear()
        session.whereAmI()
        walkUntil(15.0)
        val answer = cues.filter { it.urgency == Urgency.ASKED }
        assertEquals(listOf(CueKind.ROOM_HERE, CueKind.FACING, CueKind.DOOR), answer.map { it.kind })
        val door = answer.last()
        assertEquals(LandmarkKind.DOOR, door.landmark.kind)
        assertNotNull(plan.doors[door.landmark.index].seenFrom(answer.first().room))
        assertTrue("${door.distanceM}", door.distanceM!! in 0.1..10.0)
    }

    @Test fun wordsFollowLanguageDirectionsAndUnits() {
        fun door(style: SpeechStyle): String {
            lateinit var words: String
            walking(style) {
                walkUntil(5.0)
                session.whereAmI()
                walkUntil(15.0)
                words = cues.last { it.urgency == Urgency.ASKED && it.kind == CueKind.DOOR }.words
            }
            return words
        }
        assertTrue(door(SpeechStyle()), door(SpeechStyle()).contains("feet"))
        val german = door(SpeechStyle(Language.GERMAN, DirectionStyle.CLOCK, LengthStyle.METRES))
        assertTrue(german, german.startsWith("Tür") && "Uhr" in german && "Meter" in german)
        val french = door(SpeechStyle(Language.FRENCH, DirectionStyle.SIDES, LengthStyle.STEPS))
        assertTrue(french, french.startsWith("Porte") && "pas" in french)
    }

    @Test fun aWayLeadsFromTheWearerToThePlace() = walking {
        assertTrue(session.route.waypoints.isEmpty())
        session.setDestination(lectern)
        walkUntil(6.0)
        val route = session.route
        assertEquals(WaypointKind.START, route.waypoints.first().kind)
        assertEquals(session.estimate.room, route.waypoints.first().spot.room)
        assertEquals(WaypointKind.GOAL, route.waypoints.last().kind)
        assertEquals(plan.places[lectern.index].spot.room, route.waypoints.last().spot.room)
        assertEquals(lectern, route.goal)
        route.waypoints.filter { it.kind == WaypointKind.DOOR }.forEach { door ->
            val next = door.next!!
            val here = plan.rooms[door.spot.room].frame.toLevel(door.spot.at)
            val there = plan.rooms[next.room].frame.toLevel(next.at)
            assertTrue("a door is one place in both rooms' frames", here.distanceTo(there) < 0.5)
        }
        assertTrue(
            "${cues.map { it.words }}", cues.any { it.kind == CueKind.DESTINATION && it.words.startsWith("Lectern") },
        )
        session.clearDestination()
        walkUntil(7.0)
        assertTrue(session.route.waypoints.isEmpty())
    }

    @Test fun theWayOutEndsAtAnExit() = walking {
        session.setDestination(Destination.WAY_OUT)
        walkUntil(6.0)
        assertEquals(DestinationKind.EXIT, session.route.goal.kind)
    }

    @Test fun theWayBackFollowsTheBreadcrumbs() = walking {
        assertThrows(CoreException::class.java) { session.backTrack() }
        walkUntil(20.0)
        val crumbs = session.breadcrumbs
        assertTrue("${crumbs.size}", crumbs.size > 3)
        session.backTrack()
        walkUntil(21.0)
        assertEquals(crumbs.first().room, session.route.waypoints.last().spot.room)
    }

    @Test fun everyDestinationOfThePlanCanBeSetAndNoOther() = walking {
        assertEquals(plan.places.size + plan.exits.size + plan.rooms.size, plan.destinations.size)
        plan.destinations.forEach(session::setDestination)
        for (index in listOf(-1, 99)) {
            val error = assertThrows(CoreException::class.java) {
                session.setDestination(Destination(DestinationKind.PLACE, index))
            }
            assertTrue(error.message, error.message!!.isNotEmpty())
        }
    }

    @Test fun theLastInstructionIsRepeated() = walking {
        assertFalse(session.repeat())
        session.setDestination(lectern)
        walkUntil(10.0)
        val told = cues.size
        assertTrue("${cues.map { it.words }}", session.repeat())
        walkUntil(14.0)
        assertTrue(cues.size > told)
    }

    @Test fun mostReadingsAreExplainedByThePlan() = walking {
        assertTrue(session.scan.all { it.timeS < 0 && it.rangeM == null && it.element == Element.NONE })
        walkUntil(10.0)
        val echoes = session.scan
        assertEquals(15, echoes.size)
        val answered = echoes.filter { it.rangeM != null }
        val explained = answered.filter { it.element != Element.NONE }
        assertTrue(
            "${explained.size} of ${answered.size}", explained.size >= answered.size / 3 && explained.isNotEmpty(),
        )
        explained.forEach {
            assertTrue("$it", abs(it.expectedM!! - it.rangeM!!) < 1.2)
            assertTrue("$it", it.at!!.room in plan.rooms.indices)
        }
        echoes.filter { it.element == Element.NONE }.forEach { assertNull(it.at) }
    }

    @Test fun hypothesesAreOrderedByProbability() = walking {
        walkUntil(5.0)
        val places = session.hypotheses
        assertEquals(places.sortedByDescending { it.probability }, places)
        assertEquals(session.estimate.room, places.first().room)
        assertTrue(places.sumOf { it.probability } <= 1.0 + 1e-9)
    }

    @Test fun aBuildingIsCheckedInPlainWords() {
        assertTrue(BuildingCheck.of(laboratory.folder).usable)
        val folder = File(context.cacheDir, "checked-ü").apply { mkdirs() }
        File(folder, "building.cfg").writeText("name \"Checked\"\nunit feet\nroom 1 0 \"Lost\"\n")
        val check = BuildingCheck.of(folder)
        assertFalse(check.usable)
        val first = check.findings.first()
        assertEquals(Severity.UNUSABLE, first.severity)
        assertTrue("$first", first.file.contains("checked-ü") && first.problem.isNotEmpty())
        assertFalse("a folder that is not there", BuildingCheck.of(File(context.cacheDir, "none")).usable)
    }
}
