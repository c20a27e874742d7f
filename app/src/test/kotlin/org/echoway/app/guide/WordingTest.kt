package org.echoway.app.guide

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.engine.NoStart
import org.echoway.app.testing.SampleCues
import org.echoway.app.testing.SamplePlan
import org.echoway.core.CueKind
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Language
import org.echoway.core.RoomName
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** The exact words of the app's own lines, by situation and language. */
@RunWith(AndroidJUnit4::class)
class WordingTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()

    private fun words(message: Message, language: Language = Language.ENGLISH) =
        Wording.of(context, language).words(message)

    private val english = mapOf(
        Message.Told(SampleCues.cue(CueKind.TURN, "Turn left.")) to "Turn left.",
        Message.BeltLost to "Belt disconnected.",
        Message.BeltBack to "Belt connected.",
        Message.WaitingForBelt to "Waiting for the belt.",
        Message.Stopped to "Guidance is off.",
        Message.BeltNotAllowed to "Belt found. Allow its use on screen.",
        Message.BeltRefused to "Belt refused. “Where am I?” asks again.",
        Message.BeltChanged(12) to "Belt has twelve sensors. Finding where you are.",
        Message.BeltChanged(21) to "Belt has twenty-one sensors. Finding where you are.",
        Message.NotAPass to "No certified PASS device. Wear yours, switched on.",
        Message.WatchEnded to "Firefighter mode off.",
        Message.StillSoon to "No movement. Move, or the alarm sounds.",
        Message.StillAlarm to "Alarm. Wearer not moving.",
        Message.StillCancelled to "Alarm off.",
        Message.RecordedWalk to "Recorded walk. Not where you really are.",
        Message.Interrupted(SamplePlan.plan, null) to "Guidance was interrupted. Ask the way again.",
        Message.Interrupted(
            SamplePlan.plan, Destination.WAY_OUT,
        ) to "Guidance was interrupted. Destination stays: Way out.",
        Message.RecordingOver to "The recorded walk is over.",
        Message.SensorBlocked(Side.FRONT_LEFT, 1) to "Front left sensor blocked.",
        Message.SensorClear(Side.BACK, 7) to "Back sensor clear.",
        Message.SensorsBlocked(4) to "Four sensors blocked.",
        Message.RecordingStopped(diskFull = true) to "Recording stopped. The phone is full.",
        Message.BatteryLow to "Belt battery low.",
        Message.NoVibration to "This phone cannot vibrate.",
        Message.CannotStart(NoStart.NO_BUILDING) to "Cannot start. Choose a building in the app.",
        Message.CannotStart(NoStart.BUILDING_UNUSABLE) to "Cannot start. The floor plan is unusable.",
        Message.CannotStart(NoStart.RECORDING_UNREADABLE) to "Cannot start. The recording cannot be played.",
        Message.RoomDetail(1, emptyList()) to "One door.",
        Message.RoomDetail(3, listOf("Lectern")) to "Three doors. Lectern.",
        Message.RoomDetail(0, listOf("Lectern", "Piano")) to "Lectern, Piano.",
        Message.Unanswerable(NoAnswer.NotRunning) to "Guidance is off.",
        Message.Unanswerable(NoAnswer.NoBelt(SamplePlan.office)) to "Belt disconnected. You were in Room 1.",
        Message.Unanswerable(NoAnswer.NoBelt(null)) to "Belt disconnected.",
        Message.Unanswerable(NoAnswer.NotAllowed) to "Belt found. Allow its use on screen.",
        Message.Again("Room 2, corridor.") to "Room 2, corridor.",
        Message.NothingToRepeat to "Nothing to repeat.",
        Message.Muted(true) to "Muted. Danger is still spoken.",
        Message.Muted(false) to "Speaking again.",
        Message.CannotLead(NoWay.NO_EXIT_KNOWN) to "No exit is known here.",
        Message.CannotLead(NoWay.NOTHING_WALKED_YET) to "No way back yet.",
        Message.CannotLead(NoWay.NOT_REACHABLE) to "No way leads there.",
        Message.CannotLead(NoWay.NOT_RUNNING) to "Guidance is off.",
        Message.LeadingBack to "Back the way you came.",
        Message.LeadingStopped to "No longer leading you.",
        Message.WayBackLost to "Way back lost. Ask for the way out.",
        Message.StartedAgain(SamplePlan.plan, Destination(DestinationKind.EXIT, 0)) to "Starting again: Main entrance.",
        Message.StartedAgain(SamplePlan.plan, null) to "Starting again.",
        Message.CannotStandAt(
            SamplePlan.plan, Destination(DestinationKind.EXIT, 0),
        ) to "Cannot start at Main entrance. Choose another place.",
        Message.CannotStandAt(SamplePlan.plan, null) to "Cannot start there. Choose another place.",
    )

    @Test fun roomsAreCalledAsTheCoreCallsThem() {
        fun names(number: String, name: String, language: Language = Language.ENGLISH): Pair<String, String> {
            val room = SamplePlan.office.copy(aloud = RoomName(number, name))
            return Wording.of(context, language).run { name(room) to shortName(room) }
        }
        assertEquals("Room 2, Corridor" to "Room 2", names("2", "Corridor"))
        assertEquals("Room 2" to "Room 2", names("2", ""))
        assertEquals("Room 2" to "Room 2", names("2", "Room 2"))
        assertEquals("Hall" to "Hall", names("", "Hall"))
        assertEquals("Raum 2, Küche" to "Raum 2", names("2", "Küche", Language.GERMAN))
    }

    @Test fun situations() {
        english.forEach { (message, words) -> assertEquals(words, words(message)) }
        english.values.forEach { assertTrue(it, it.split(' ').size <= 8) }
    }

    @Test fun everyLanguageHasItsOwnWords() {
        val namesOnly = Message.RoomDetail(0, listOf("Lectern", "Piano"))
        for (language in listOf(Language.GERMAN, Language.FRENCH)) {
            for (message in english.keys) {
                // What the core or the plan words is the same in every language.
                if (message is Message.Told || message is Message.Again || message == namesOnly) continue
                val line = words(message, language)
                assertTrue("$language: $line", line.isNotEmpty() && line != words(message))
                assertTrue("$language: $line", line.split(' ').size <= 8)
            }
        }
        assertEquals("Sensor vorn links verdeckt.", words(Message.SensorBlocked(Side.FRONT_LEFT, 1), Language.GERMAN))
        assertEquals("Capteur avant gauche masqué.", words(Message.SensorBlocked(Side.FRONT_LEFT, 1), Language.FRENCH))
    }

    @Test fun pluralsAreThoseOfTheLanguage() {
        val doors = { count: Int, language: Language -> words(Message.RoomDetail(count, emptyList()), language) }
        assertEquals(
            listOf("One door.", "Two doors.", "Twelve doors."), listOf(1, 2, 12).map { doors(it, Language.ENGLISH) },
        )
        assertEquals(
            listOf("Eine Tür.", "Zwei Türen.", "Zwölf Türen."), listOf(1, 2, 12).map { doors(it, Language.GERMAN) },
        )
        assertEquals(
            listOf("Une porte.", "Deux portes.", "Douze portes."), listOf(1, 2, 12).map { doors(it, Language.FRENCH) },
        )
    }

    @Test fun destinationsAreCalledWhatTheyAre() {
        val name = { kind: DestinationKind, index: Int, language: Language ->
            Wording.of(context, language).name(SamplePlan.plan, Destination(kind, index))
        }
        assertEquals("Lectern", name(DestinationKind.PLACE, 0, Language.ENGLISH))
        assertEquals("Main entrance", name(DestinationKind.EXIT, 0, Language.GERMAN))
        assertEquals("Raum 4, Seminar room", name(DestinationKind.ROOM, 1, Language.GERMAN))
        assertEquals("Way out", name(DestinationKind.NEAREST_EXIT, -1, Language.ENGLISH))
    }
}
