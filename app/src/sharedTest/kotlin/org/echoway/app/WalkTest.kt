package org.echoway.app

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.emptyFlow
import kotlinx.coroutines.flow.filterNot
import kotlinx.coroutines.flow.transform
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.StandardTestDispatcher
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource
import org.echoway.app.belt.LoggedRestart
import org.echoway.app.belt.ReplayedBelt
import org.echoway.app.belt.WalkLog
import org.echoway.app.belt.WireSentence
import org.echoway.app.building.BundledBuildings
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Navigator
import org.echoway.app.engine.Picture
import org.echoway.app.engine.Wish
import org.echoway.app.guide.Ask
import org.echoway.app.guide.Guide
import org.echoway.app.guide.SpeechQueue
import org.echoway.app.guide.Wording
import org.echoway.app.motion.MotionSource
import org.echoway.app.settings.Settings
import org.echoway.app.testing.RecordingBuzzer
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.VirtualClock
import org.echoway.app.touch.Touch
import org.echoway.core.Destination
import org.echoway.core.Start
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/**
 * From the belt's bytes through the core to the words and the vibration, for a simulated walk through the Torgersen
 * laboratory: what was heard must tell the way that was really walked.
 */
@RunWith(AndroidJUnit4::class)
@OptIn(ExperimentalCoroutinesApi::class)
class WalkTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()

    private class Walk(
        val voice: RecordingVoice,
        val buzzer: RecordingBuzzer,
        val navigator: Navigator,
        val guide: Guide,
    )

    /** Plays the walk that comes with the app, in virtual time; [distort] changes what the belt sends. */
    private fun walking(
        start: (rooms: List<String>) -> Start = { Start(room = it.indexOf("1")) },
        distort: (Flow<BeltEvent>) -> Flow<BeltEvent> = { it },
        test: suspend TestScope.(Walk) -> Unit,
    ) = runTest {
        val clock = VirtualClock(testScheduler)
        val thread: CoroutineDispatcher = StandardTestDispatcher(testScheduler)
        val voice = RecordingVoice(clock)
        val buzzer = RecordingBuzzer()
        val navigator = Navigator(thread, clock)
        val speech = SpeechQueue(voice, clock, backgroundScope)
        val walk = Walk(voice, buzzer, navigator, Guide({ Wording.of(context, it) }, speech, buzzer, navigator, clock))
        val building = BundledBuildings(context, 1).find("torgersen-lab")!!
        val replay = ReplayedBelt(clock) { bundledLog() }
        val belt = object : BeltSource {
            override val events = distort(replay.events)
            override val bringsMotion = true
        }
        val settings = MutableStateFlow(Settings())
        backgroundScope.launch { walk.guide.follow(settings) }
        backgroundScope.launch { walk.guide.run(navigator.state, navigator.events, settings) }
        backgroundScope.launch {
            walk.navigator.run(building, start(building.plan.rooms.map { it.id }), belt, MotionSource { emptyFlow() })
        }
        test(walk)
    }

    private fun bundledLog(): WalkLog {
        fun asset(kind: String) = context.assets.open("walks/torgersen-lab.$kind.csv").bufferedReader()
        return WalkLog.read(asset("scans"), asset("motion"))
    }

    /** Rooms that were really walked through, with the time each was entered. */
    private val truth: List<Pair<Double, String>> by lazy {
        val rows = javaClass.getResourceAsStream("/walks/torgersen-lab.truth.csv")!!.bufferedReader()
            .readLines()
            .drop(1)
            .map { it.split(',') }
        rows.map { it[0].toDouble() to it[1] }
            .fold(emptyList()) { way, row -> if (way.lastOrNull()?.second == row.second) way else way + row }
    }

    private fun Flow<BeltEvent>.silentBetween(fromS: Double, untilS: Double) =
        filterNot { it is BeltEvent.Bytes && it.arrivalS in fromS..untilS }

    /** Sensor 1 fails: the belt says so with every sentence from then on. */
    private fun Flow<BeltEvent>.withFault(atS: Double) = transform { event ->
        emit(event)
        if (event is BeltEvent.Bytes && event.arrivalS >= atS) {
            emit(BeltEvent.Bytes(WireSentence.sentence("EWF,1,2"), event.arrivalS))
        }
    }

    private val entering = Regex("Room (\\w+), [^.]+\\.")

    @Test fun theWordsTellTheWayThatWasWalked() = walking { walk ->
        advanceTimeBy(60_000)
        val told = walk.voice.heard.filter { entering.matches(it.text) }
        assertEquals(truth.map { it.second }, told.map { entering.matchEntire(it.text)!!.groupValues[1] })
        told.zip(truth).forEach { (line, entered) ->
            assertTrue(
                "${line.text} at ${line.timeS} s, entered at ${entered.first} s",
                line.timeS - entered.first in -1.5..5.0,
            )
        }
        assertTrue(
            "nothing was lost on the way: ${walk.voice.words}", walk.voice.words.none { it.startsWith("Not sure") },
        )
        assertEquals(listOf("Recorded walk. Not where you really are.", "Belt connected."), walk.voice.words.take(2))
        assertEquals("The recorded walk is over.", walk.voice.words.last())
        assertTrue("${walk.voice.words}", walk.voice.words.any { Regex("Lectern [a-z ]+, [a-z ]+\\.").matches(it) })
        walk.voice.words.filter { it.startsWith("Door ") }.forEach {
            assertTrue(it, Regex("Door [a-z ]+, [a-z ]+ (feet|foot)\\.").matches(it))
        }
    }

    @Test fun everyRoomIsFelt() = walking { walk ->
        advanceTimeBy(60_000)
        assertEquals(truth.size, walk.buzzer.felt.count { it == Touch.ROOM_ENTERED })
        assertEquals(0, walk.buzzer.felt.count { it == Touch.UNSURE })
    }

    @Test fun whereAmIIsAnsweredInTheSeminarRoom() = walking { walk ->
        val inSeminarRoom = truth.zipWithNext().first { it.first.second == "4" }
        advanceTimeBy(((inSeminarRoom.first.first + inSeminarRoom.second.first) / 2 * 1000).toLong())
        walk.guide.ask(Ask.WHERE_AM_I)
        advanceTimeBy(12_000)
        val words = walk.voice.words
        val answer = words.drop(words.lastIndexOf("Room 4, Seminar room.")).take(3)
        assertTrue("$answer", answer[1].startsWith("Facing "))
        assertTrue("$answer", Regex("Door [a-z ]+, [a-z ]+\\.").matches(answer[2]))
    }

    @Test fun oneIsLedToTheNearestExit() = walking { walk ->
        advanceTimeBy(3_000)
        walk.guide.ask(Ask.WAY_OUT)
        advanceTimeBy(6_000)
        val leading = (walk.navigator.state.value as NavigationState.Running).leading
        assertEquals(Destination.WAY_OUT, (leading as Wish.LeadTo).destination)
        assertTrue("${walk.voice.words}", walk.voice.words.any { "entrance: " in it || "stairs: " in it })
    }

    @Test fun thePictureIsDrawnWhileAnybodyLooks() = walking { walk ->
        advanceTimeBy(20_000)
        assertEquals(Picture(), walk.navigator.picture.value)
        backgroundScope.launch { walk.navigator.picture.collect {} }
        walk.guide.ask(Ask.WAY_BACK)
        advanceTimeBy(2_000)
        val picture = walk.navigator.picture.value
        assertEquals(15, picture.scan.size)
        assertTrue("$picture", picture.breadcrumbs.size > 2 && picture.hypotheses.isNotEmpty())
        assertTrue("$picture", picture.route.waypoints.isNotEmpty())
    }

    @Test fun aBeltThatFallsSilentIsToldWithinTwoSecondsAndToldAgainWhenItIsBack() = walking(
        distort = { events -> events.silentBetween(8.0, 14.0) },
    ) { walk ->
        advanceTimeBy(20_000)
        val lost = walk.voice.heard.first { it.text == "Belt disconnected." }
        assertTrue("told at ${lost.timeS} s", lost.timeS in 8.0..10.0)
        val back = walk.voice.heard.first { it.text == "Belt connected." && it.timeS > lost.timeS }
        assertTrue("told at ${back.timeS} s", back.timeS in 14.0..16.0)
        assertEquals(1, walk.buzzer.felt.count { it == Touch.BELT_LOST })
    }

    @Test fun aSensorThatTheBeltReportsBrokenIsTold() = walking(
        distort = { events -> events.withFault(atS = 7.0) },
    ) { walk ->
        advanceTimeBy(10_000)
        val line = walk.voice.heard.first { it.text == "Front left sensor blocked." }
        assertTrue("told at ${line.timeS} s", line.timeS in 7.0..9.0)
    }

    @Test fun aRecordingStartsOverWhereItsWearerDid() = walking(
        start = { Start(room = it.indexOf("hall")) }, // not where the walk begins
        distort = { events -> events.transform { event ->
            if (event is BeltEvent.Bytes && event.arrivalS >= 2.0 && !restarted) {
                restarted = true
                emit(BeltEvent.Restart(LoggedRestart(2.0, "nowhere", null, null)))
                emit(BeltEvent.Restart(LoggedRestart(2.0, "1", null, null)))
            }
            emit(event)
        } },
    ) { walk ->
        advanceTimeBy(8_000)
        val state = walk.navigator.state.value as NavigationState.Running
        assertEquals("1", state.building.plan.rooms[state.estimate.room].id)
    }

    private var restarted = false

    @Test fun theEstimateIsPublishedForEveryFiring() = walking { walk ->
        advanceTimeBy(3_000)
        runCurrent()
        val state = walk.navigator.state.value as NavigationState.Running
        val newest = state.belt.sensors.maxOf { it.lastTimeS }
        assertTrue(state.estimate.timeS >= newest)
    }
}
