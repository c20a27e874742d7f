package org.echoway.app.guide

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runTest
import org.echoway.app.settings.ServiceModel
import org.echoway.app.settings.Verbosity
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.SampleCues
import org.echoway.app.testing.VirtualClock
import org.echoway.core.CueKind
import org.echoway.core.CueKind.ARRIVED
import org.echoway.core.CueKind.BEAR
import org.echoway.core.CueKind.DESTINATION
import org.echoway.core.CueKind.DOOR
import org.echoway.core.CueKind.ELEVATOR
import org.echoway.core.CueKind.ENTERING
import org.echoway.core.CueKind.EXIT
import org.echoway.core.CueKind.FACING
import org.echoway.core.CueKind.FOUND
import org.echoway.core.CueKind.GO_STRAIGHT
import org.echoway.core.CueKind.NARROW
import org.echoway.core.CueKind.NO_WAY
import org.echoway.core.CueKind.OBSTACLE
import org.echoway.core.CueKind.PLACE
import org.echoway.core.CueKind.REROUTED
import org.echoway.core.CueKind.ROOM_HERE
import org.echoway.core.CueKind.STAIRS
import org.echoway.core.CueKind.STOP
import org.echoway.core.CueKind.TAKE_LINK
import org.echoway.core.CueKind.TURN
import org.echoway.core.CueKind.UNCERTAIN
import org.echoway.core.CueKind.WRONG_WAY
import org.echoway.core.Language
import org.echoway.core.Urgency
import org.junit.Assert.assertEquals
import org.junit.Test
import org.junit.runner.RunWith

/**
 * The table of situations: the exact words, in which manners of speaking they are heard, and how long they may wait
 * while the voice is not to be had. What the core says it words itself (its own tests have the same lines).
 */
@RunWith(AndroidJUnit4::class)
@OptIn(ExperimentalCoroutinesApi::class)
class SituationsTest {
    private val wording = Wording.of(ApplicationProvider.getApplicationContext<Context>(), Language.ENGLISH)

    /** [heard]: b, n, f: what is needed, rooms and doors too, everything; r: only when asked; m: muted. */
    private class Row(
        val situation: String,
        val words: String,
        val heard: String,
        val validS: Double,
        val message: Message,
    )

    private fun core(
        situation: String,
        words: String,
        heard: String,
        validS: Double,
        kind: CueKind,
        asked: Boolean = false,
    ): Row {
        val cue = SampleCues.cue(kind, words).let { if (asked) it.copy(urgency = Urgency.ASKED) else it }
        return Row(situation, words, heard, validS, Message.Told(cue))
    }

    /** [TTL_S] is the core's own, for lines that are true only here. */
    private val table = listOf(
        core("where am I: room", "Room 4, Seminar room.", "bnfrm", 12.0, ROOM_HERE),
        core("where am I: facing", "Facing the window wall.", "bnfrm", 12.0, FACING),
        core("where am I: door", "Door behind you, eight feet.", "bnfrm", 12.0, DOOR, asked = true),
        core("where to: how far", "Lectern: forty feet.", "bnfrm", 12.0, DESTINATION),
        core("entering", "Room 2, corridor.", "nf", 6.0, ENTERING),
        core("door near on the way", "Door right, six feet.", "nf", TTL_S, DOOR),
        core("exit near on the way", "Exit left, six feet.", "nf", TTL_S, EXIT),
        core("place near on the way", "Lectern left, three feet.", "nf", TTL_S, PLACE),
        core("narrow", "Narrow ahead.", "bnf", TTL_S, NARROW),
        core("turn", "Turn left.", "bnf", TTL_S, TURN),
        core("small correction", "Bear left.", "bnf", TTL_S, BEAR),
        core("straight", "Go straight, twenty feet.", "bnf", TTL_S, GO_STRAIGHT),
        core("take the elevator", "Take the elevator up to level two.", "bnf", TTL_S, TAKE_LINK),
        core("arrived", "Arrived: Lectern, on your right.", "bnfr", TTL_S, ARRIVED),
        core("off the route", "Wrong way. Turn around.", "bnfrm", TTL_S, WRONG_WAY),
        core("new route", "New route. Turn right.", "bnf", TTL_S, REROUTED),
        core("nothing leads there", "No way there.", "bnfrm", TTL_S, NO_WAY),
        core("stairs", "Stairs up ahead, five feet. Eight steps.", "bnf", TTL_S, STAIRS),
        core("elevator", "Elevator ahead, five feet.", "bnf", TTL_S, ELEVATOR),
        core("unmapped near echo ahead", "Something ahead, three feet.", "bnfrm", TTL_S, OBSTACLE),
        core("the next step may meet a wall", "Stop.", "bnfrm", TTL_S, STOP),
        core("unsure", "Not sure where you are. Stop and turn slowly.", "bnfrm", 120.0, UNCERTAIN),
        core("found again", "Room 2 again. Door left.", "bnfrm", 120.0, FOUND),
        Row("sensor silent", "Front left sensor blocked.", "bnfrm", 120.0, Message.SensorBlocked(Side.FRONT_LEFT, 1)),
        Row("belt lost", "Belt disconnected.", "bnfrm", 120.0, Message.BeltLost),
        Row("belt back", "Belt connected.", "bnfrm", 6.0, Message.BeltBack),
        Row("battery", "Belt battery low.", "bnfrm", 120.0, Message.BatteryLow),
        Row("nice to know of a room", "Three doors. Lectern.", "f", 6.0, Message.RoomDetail(3, listOf("Lectern"))),
        Row("asked while guidance is off", "Guidance is off.", "bnfrm", 6.0, Message.Unanswerable(NoAnswer.NotRunning)),
        Row("muted", "Muted. Danger is still spoken.", "bnfrm", 6.0, Message.Muted(true)),
    )

    private val manners = mapOf(
        'b' to Manner(verbosity = Verbosity.BRIEF),
        'n' to Manner(verbosity = Verbosity.NORMAL),
        'f' to Manner(verbosity = Verbosity.FULL),
        'r' to Manner(service = ServiceModel.ON_REQUEST, verbosity = Verbosity.FULL),
        'm' to Manner(verbosity = Verbosity.FULL, muted = true),
    )

    @Test fun theWords() = table.forEach { assertEquals(it.situation, it.words, wording.words(it.message)) }

    @Test fun whoHearsThem() = table.forEach { row ->
        assertEquals(row.situation, row.heard, manners.filterValues { it.speaks(row.message) }.keys.joinToString(""))
    }

    @Test fun howLongTheyWait() = table.forEach { row ->
        assertEquals("${row.situation}, in time", listOf(row.words), heardAfter(row, row.validS - 1.5))
        assertEquals("${row.situation}, too late", emptyList<String>(), heardAfter(row, row.validS + 0.5))
    }

    /** What is heard when the voice is not to be had, as in a call, for so long. */
    private fun heardAfter(row: Row, seconds: Double): List<String> {
        val heard = mutableListOf<String>()
        runTest {
            val clock = VirtualClock(testScheduler)
            val voice = RecordingVoice(clock).apply { refuse = true }
            SpeechQueue(voice, clock, backgroundScope).say(row.words, row.message)
            advanceTimeBy((seconds * 1000).toLong())
            voice.refuse = false
            advanceTimeBy(10_000)
            heard += voice.words
        }
        return heard
    }

    private companion object {
        const val TTL_S = 2.0
    }
}
