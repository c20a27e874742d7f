package org.echoway.app.guide

import android.content.Context
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.flow.MutableSharedFlow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import org.echoway.app.engine.GuidanceEvent
import org.echoway.app.engine.Line
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.app.settings.ServiceModel
import org.echoway.app.settings.Settings
import org.echoway.app.settings.Verbosity
import org.echoway.app.testing.MemorySettings
import org.echoway.app.testing.RecordingBuzzer
import org.echoway.app.testing.RecordingCore
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.SampleCues
import org.echoway.app.testing.SampleCues.told
import org.echoway.app.testing.SamplePlan
import org.echoway.app.testing.VirtualClock
import org.echoway.app.touch.Touch
import org.echoway.core.BeltLink
import org.echoway.core.CueKind
import org.echoway.core.CueTail
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.DirectionStyle
import org.echoway.core.Language
import org.echoway.core.LengthStyle
import org.echoway.core.RoutePreferences
import org.echoway.core.SpeechStyle
import org.echoway.core.Start
import org.echoway.core.Urgency
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith

/** Situations, and the exact words that are heard in them, in order. */
@RunWith(AndroidJUnit4::class)
@OptIn(ExperimentalCoroutinesApi::class)
class GuideTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()

    private inner class Situation(val scope: TestScope, settings: Settings) {
        val voice = RecordingVoice(VirtualClock(scope.testScheduler))
        val buzzer = RecordingBuzzer()
        val core = RecordingCore()
        val settings = MemorySettings(settings)
        private val states = MutableStateFlow<NavigationState>(NavigationState.Idle)
        private val events = MutableSharedFlow<GuidanceEvent>(extraBufferCapacity = 64)
        private val clock = VirtualClock(scope.testScheduler)
        val guide =
            Guide({ Wording.of(context, it) }, SpeechQueue(voice, clock, scope.backgroundScope), buzzer, core, clock)

        init {
            scope.backgroundScope.launch { guide.follow(this@Situation.settings.settings) }
            scope.backgroundScope.launch { guide.run(states, events, this@Situation.settings.settings) }
            scope.runCurrent()
        }

        fun state(change: (NavigationState.Running) -> NavigationState = { it }) {
            states.value = change(SamplePlan.running(scope.testScheduler.currentTime / 1000.0, inOffice))
            scope.runCurrent()
        }

        fun happens(vararg events: GuidanceEvent) {
            events.forEach { this.events.tryEmit(it) }
            scope.runCurrent()
        }

        fun wait(seconds: Double) = scope.advanceTimeBy((seconds * 1000).toLong())

        fun heard(): List<String> {
            wait(15.0)
            return voice.words.toList().also { voice.heard.clear() }
        }
    }

    private val inOffice = SamplePlan.estimate(room = 0, x = 2.0, y = 1.0)

    /** Guidance that has been on for a while. */
    private fun walking(settings: Settings = Settings(), test: Situation.() -> Unit) = runTest {
        Situation(this, settings).run {
            state()
            heard()
            buzzer.felt.clear()
            test()
        }
    }

    private val room = told(CueKind.ENTERING, "Room 4, Seminar room.")
    private val door = told(CueKind.DOOR, "Door right, six feet.")
    private val stairs = told(CueKind.STAIRS, "Stairs up ahead, five feet.")
    private val turn = told(CueKind.TURN, "Turn left.", 90.0)
    private val straight = told(CueKind.GO_STRAIGHT, "Go straight, twenty feet.")
    private val wrongWay = told(CueKind.WRONG_WAY, "Wrong way. Turn around.")
    private val arrived = told(CueKind.ARRIVED, "Arrived: Lectern, on your right.")
    private val unsure = told(CueKind.UNCERTAIN, "Not sure where you are. Stop and turn slowly.")
    private val obstacle = told(CueKind.OBSTACLE, "Something ahead, three feet.", 0.0)
    private val answer = listOf(
        told(CueKind.ROOM_HERE, "Room 4, Seminar room."),
        told(CueKind.FACING, "Facing the wall, ten feet."),
        GuidanceEvent.Told(SampleCues.cue(CueKind.DOOR, "Door behind you, eight feet.", urgency = Urgency.ASKED)),
    )
    private val entering = GuidanceEvent.Told(SampleCues.cue(CueKind.ENTERING, "Room 4, Seminar room.", room = 1))

    /** What is heard of each line when it comes alone. */
    private fun spoken(settings: Settings, mute: Boolean = false): Set<String> {
        val lines = listOf(entering, door, stairs, turn, straight, wrongWay, arrived, unsure, obstacle) + answer
        val heard = mutableSetOf<String>()
        walking(settings) {
            if (mute) guide.ask(Ask.MUTE)
            heard() // "Muted."
            lines.forEach {
                happens(it)
                heard += heard()
            }
        }
        return heard
    }

    @Test fun verbosityAndServiceModelDecideWhatIsHeard() {
        val always =
            setOf(wrongWay, unsure, obstacle, answer[1], answer[2]).map { it.cue.words }.toSet() + answer[0].cue.words
        val ways = setOf(turn, straight, arrived).map { it.cue.words }
        // The answer has the same words as entering the room: enteringIsHeardUnlessBrief tells them apart.
        assertEquals(always + ways + stairs.cue.words, spoken(Settings(verbosity = Verbosity.BRIEF)))
        assertEquals(always + ways + stairs.cue.words + door.cue.words, spoken(Settings(verbosity = Verbosity.NORMAL)))
        assertEquals(
            always + ways + stairs.cue.words + door.cue.words + "One door. Lectern.",
            spoken(Settings(verbosity = Verbosity.FULL)),
        )
        assertEquals(always + arrived.cue.words, spoken(Settings(service = ServiceModel.ON_REQUEST)))
        assertEquals(always, spoken(Settings(verbosity = Verbosity.FULL), mute = true))
    }

    @Test fun enteringIsHeardUnlessBrief() = walking {
        happens(room)
        assertEquals(listOf("Room 4, Seminar room."), heard())
        choose { it.copy(verbosity = Verbosity.BRIEF) }
        wait(15.0)
        happens(told(CueKind.ENTERING, "Room 1, Office."))
        assertEquals(emptyList<String>(), heard())
    }

    private fun Situation.choose(change: (Settings) -> Settings) {
        settings.settings.value = change(settings.settings.value)
        scope.runCurrent()
    }

    @Test fun dangerComesBeforeEverythingElse() = walking {
        happens(room, door)
        wait(0.1)
        happens(obstacle)
        assertEquals("Something ahead, three feet.", heard()[1])
    }

    @Test fun whatWaitedTooLongIsDropped() = walking {
        happens(unsure)
        wait(0.1)
        happens(door, turn)
        assertEquals("nine words outlast a door and a turn", listOf(unsure.cue.words), heard())
    }

    @Test fun aLossIsSaidHoweverLateAndFollowedByWhatTakesItBack() = walking {
        voice.refuse = true // a call
        happens(unsure)
        wait(30.0)
        voice.refuse = false
        assertEquals(listOf(unsure.cue.words), heard())
        voice.refuse = true
        happens(unsure)
        wait(5.0)
        happens(told(CueKind.FOUND, "Room 4 again."))
        voice.refuse = false
        wait(4.0)
        assertEquals("found again by the end of the call", listOf("Room 4 again."), heard())
    }

    @Test fun aDestinationIsConfirmedAndLedTo() = walking {
        guide.leadTo(Destination(DestinationKind.PLACE, 0))
        assertEquals(listOf(Wish.LeadTo(Destination(DestinationKind.PLACE, 0))), core.wishes)
        happens(told(CueKind.DESTINATION, "Lectern: forty feet."), turn)
        assertEquals(listOf("Turn left.", "Lectern: forty feet."), heard())
    }

    @Test fun everyAskIsAnswered() = walking {
        guide.ask(Ask.WHERE_AM_I)
        guide.ask(Ask.WAY_OUT)
        guide.ask(Ask.WAY_BACK)
        guide.ask(Ask.STOP_LEADING)
        assertEquals(
            listOf(Wish.WhereAmI, Wish.LeadTo(Destination.WAY_OUT), Wish.BackTrack, Wish.StopLeading), core.wishes,
        )
        happens(*core.wishes.map(GuidanceEvent::Granted).toTypedArray())
        assertEquals("the newest word on leading is the one that counts", listOf("No longer leading you."), heard())
    }

    @Test fun avoidingStairsIsPassedOn() = walking(Settings(avoidStairs = true)) {
        guide.ask(Ask.WAY_OUT)
        assertEquals(listOf<Wish>(Wish.LeadTo(Destination.WAY_OUT, RoutePreferences(avoidStairs = true))), core.wishes)
    }

    @Test fun whereAmIWithoutABeltOrGuidance() = walking {
        state { it.copy(line = Line.GONE, belt = SamplePlan.health(BeltLink.LOST)) }
        heard()
        guide.ask(Ask.WHERE_AM_I)
        assertEquals(listOf("Belt disconnected. You were in Room 1."), heard())
        state { NavigationState.Idle }
        guide.ask(Ask.WHERE_AM_I)
        guide.ask(Ask.WAY_OUT)
        assertEquals(emptyList<Wish>(), core.wishes)
        assertEquals("Guidance is off.", heard().first())
    }

    @Test fun nothingIsConfirmedThatIsThenRefused() = walking(Settings(entrance = "Main entrance")) {
        guide.ask(Ask.WAY_BACK)
        happens(GuidanceEvent.Refused(core.wishes.last(), ""))
        assertEquals(listOf("No way back yet."), heard())
        guide.ask(Ask.START_AGAIN)
        happens(GuidanceEvent.Refused(core.wishes.last(), ""))
        assertEquals(listOf("Cannot start at Main entrance. Choose another place."), heard())
    }

    @Test fun aBeltRefusedByMistakeIsAllowedBySayingSo() = walking {
        state { it.copy(line = Line.REFUSED, belt = SamplePlan.health(BeltLink.ABSENT)) }
        assertEquals(listOf("Belt refused. “Where am I?” asks again."), heard())
        guide.ask(Ask.WHERE_AM_I)
        assertEquals(listOf<Wish>(Wish.AllowBelt), core.wishes)
        assertEquals(listOf("Belt found. Allow its use on screen."), heard())
        guide.ask(Ask.WAY_OUT)
        assertEquals(
            "who wants out is asked too", listOf(Wish.LeadTo(Destination.WAY_OUT), Wish.AllowBelt), core.wishes.drop(1),
        )
    }

    @Test fun whoWantsBackIsAskedAgainForTheBeltTheyRefused() = walking {
        state { it.copy(line = Line.REFUSED, belt = SamplePlan.health(BeltLink.ABSENT)) }
        heard()
        guide.ask(Ask.WAY_BACK)
        happens(GuidanceEvent.Granted(Wish.BackTrack))
        assertEquals(listOf(Wish.BackTrack, Wish.AllowBelt), core.wishes)
        assertEquals(listOf("Back the way you came.", "Belt found. Allow its use on screen."), heard())
        guide.ask(Ask.WAY_BACK)
        happens(GuidanceEvent.Refused(Wish.BackTrack, ""))
        assertEquals("before the first step too", listOf(Wish.BackTrack, Wish.AllowBelt), core.wishes.drop(2))
        assertEquals(listOf("No way back yet.", "Belt found. Allow its use on screen."), heard())
    }

    @Test fun aRecordedWalkIsSaidToBeNoneOfOnesOwn() = runTest {
        Situation(this, Settings()).run {
            state { it.copy(live = false) }
            assertEquals(listOf("Recorded walk. Not where you really are.", "Belt connected."), heard())
            state { it.copy(live = false, timeS = 20.0) }
            assertEquals(emptyList<String>(), heard())
        }
    }

    @Test fun aBeltWithOtherSensorsAndAWayBackThatIsLostAreSaidThoughMuted() = walking {
        guide.ask(Ask.MUTE)
        heard()
        happens(GuidanceEvent.BeltChanged(12), GuidanceEvent.WayBackLost)
        assertEquals(
            listOf("Belt has twelve sensors. Finding where you are.", "Way back lost. Ask for the way out."), heard(),
        )
        assertEquals(Touch.UNSURE, buzzer.felt.last())
    }

    @Test fun repeatSaysTheLastLineButNeverAnOldInstruction() = walking {
        happens(door)
        wait(4.0)
        guide.ask(Ask.REPEAT)
        guide.ask(Ask.REPEAT)
        assertEquals(listOf("Door right, six feet.", "Door right, six feet."), heard())
        happens(turn)
        heard()
        guide.ask(Ask.REPEAT)
        assertEquals(listOf<Wish>(Wish.Repeat), core.wishes)
        happens(GuidanceEvent.Refused(Wish.Repeat, ""))
        assertEquals(listOf("Nothing to repeat."), heard())
    }

    @Test fun muteHoldsBackChatterAndIsTakenBack() = walking {
        guide.ask(Ask.MUTE)
        assertTrue(guide.muted.value)
        heard()
        happens(room, door, turn)
        assertEquals(emptyList<String>(), heard())
        assertEquals("touch goes on", Touch.LEFT, buzzer.felt.last())
        happens(obstacle)
        assertEquals(listOf("Something ahead, three feet."), heard())
        guide.ask(Ask.MUTE)
        assertFalse(guide.muted.value)
        happens(door)
        assertEquals(listOf("Speaking again.", "Door right, six feet."), heard())
    }

    @Test fun whoSaysWhereTheyStandIsLookedForFromThere() = walking(Settings(entrance = "Main entrance")) {
        guide.ask(Ask.START_AGAIN)
        assertEquals(Wish.StandAt(Start(room = 0), Destination(DestinationKind.EXIT, 0)), core.wishes.last())
        happens(GuidanceEvent.Granted(core.wishes.last()))
        assertEquals(listOf("Starting again: Main entrance."), heard())
        guide.standAt(Destination(DestinationKind.ROOM, 1))
        assertEquals(Wish.StandAt(Start(room = 1), Destination(DestinationKind.ROOM, 1)), core.wishes.last())
        happens(GuidanceEvent.Granted(core.wishes.last()))
        assertEquals(listOf("Starting again: Room 4, Seminar room."), heard())
    }

    @Test fun whoDoesNotKnowWhereTheyStandIsLookedForEverywhere() = walking {
        guide.ask(Ask.START_AGAIN)
        assertEquals(Wish.StandAt(Start()), core.wishes.last())
        happens(GuidanceEvent.Granted(core.wishes.last()))
        assertEquals(listOf("Starting again."), heard())
    }

    @Test fun nobodyIsLookedForWhileGuidanceIsOff() = runTest {
        Situation(this, Settings(entrance = "Main entrance")).run {
            guide.ask(Ask.START_AGAIN)
            assertEquals(listOf("Guidance is off."), heard())
            assertEquals(emptyList<Wish>(), core.wishes)
        }
    }

    @Test fun cuesAreWordedAsTheWearerWants() = walking(
        Settings(directions = DirectionStyle.CLOCK, lengths = LengthStyle.METRES),
    ) {
        assertEquals(SpeechStyle(Language.ENGLISH, DirectionStyle.CLOCK, LengthStyle.METRES), core.style)
        choose { it.copy(language = Language.FRENCH) }
        assertEquals(Language.FRENCH, core.style?.language)
        guide.ask(Ask.MUTE)
        assertEquals(listOf("Muet. Les dangers sont encore annoncés."), heard())
    }

    @Test fun everyWordOfTouchHasItsSituation() = walking {
        fun felt(event: GuidanceEvent): Touch? {
            buzzer.felt.clear()
            happens(event)
            return buzzer.felt.singleOrNull()
        }
        val tail = { degrees: Double -> CueTail(CueKind.TURN, Math.toRadians(degrees), null) }
        assertEquals(Touch.LEFT, felt(turn))
        assertEquals(Touch.LEFT, felt(told(CueKind.TURN, "Turn slightly left.", 30.0)))
        assertEquals(Touch.RIGHT, felt(told(CueKind.TURN, "Turn sharp right.", -150.0)))
        assertEquals(Touch.TURN_AROUND, felt(told(CueKind.TURN, "Turn around.", 175.0)))
        assertEquals(
            Touch.TURN_AROUND, felt(GuidanceEvent.Told(SampleCues.cue(CueKind.WRONG_WAY, "", tail = tail(180.0)))),
        )
        assertEquals(Touch.RIGHT, felt(GuidanceEvent.Told(SampleCues.cue(CueKind.STOP, "", tail = tail(-90.0)))))
        assertEquals(Touch.SOMETHING_AHEAD, felt(told(CueKind.STOP, "Stop.")))
        assertEquals(Touch.AHEAD, felt(straight))
        assertEquals(Touch.ARRIVED, felt(arrived))
        assertEquals(Touch.UNSURE, felt(unsure))
        assertEquals(Touch.ROOM_ENTERED, felt(room))
        assertEquals(Touch.ROOM_ENTERED, felt(told(CueKind.FOUND, "Room 4 again.")))
        assertEquals("a small correction is only spoken", null, felt(told(CueKind.BEAR, "Bear left.", 25.0)))
    }

    @Test fun withoutVibrationNothingIsFelt() = walking(Settings(vibration = false)) {
        happens(turn, unsure)
        state { it.copy(obstacleM = 0.5) }
        wait(3.0)
        assertEquals(emptyList<Touch>(), buzzer.felt)
    }

    @Test fun ticksQuickenAsSomethingComesNearerAndEndWithIt() = walking {
        fun ticks(distanceM: Double): Int {
            buzzer.felt.clear()
            state { it.copy(obstacleM = distanceM) }
            wait(2.0)
            return buzzer.felt.count { it == Touch.SOMETHING_AHEAD }
        }
        val far = ticks(2.5)
        val near = ticks(1.2)
        val close = ticks(0.4)
        assertTrue("$far, $near, $close", far in 2..6 && near > far && close > near)
        state { it.copy(obstacleM = null) }
        buzzer.felt.clear()
        wait(2.0)
        assertEquals(emptyList<Touch>(), buzzer.felt)
    }

    @Test fun ticksMakeWayForAWordUntilItIsOver() = walking {
        state { it.copy(obstacleM = 0.4) }
        wait(1.0)
        buzzer.felt.clear()
        happens(turn)
        wait(0.6)
        assertEquals("long, short takes half a second", listOf(Touch.LEFT), buzzer.felt)
        wait(1.0)
        assertTrue(buzzer.felt.count { it == Touch.SOMETHING_AHEAD } > 5)
    }

    @Test fun ticksStopWhenTheBeltIsLost() = walking {
        state { it.copy(obstacleM = 0.5) }
        wait(1.0)
        state { it.copy(obstacleM = 0.5, line = Line.GONE) }
        buzzer.felt.clear()
        wait(2.0)
        assertEquals(emptyList<Touch>(), buzzer.felt)
    }

    @Test fun aPhoneThatCannotVibrateSaysSoOnce() = runTest {
        val clock = VirtualClock(testScheduler)
        val voice = RecordingVoice(clock)
        val guide = Guide(
            { Wording.of(context, it) },
            SpeechQueue(voice, clock, backgroundScope),
            RecordingBuzzer(present = false),
            RecordingCore(),
            clock,
        )
        backgroundScope.launch {
            guide.run(MutableStateFlow(NavigationState.Idle), MutableSharedFlow(), MutableStateFlow(Settings()))
        }
        advanceTimeBy(5_000)
        assertEquals(listOf("This phone cannot vibrate."), voice.words)
    }
}
