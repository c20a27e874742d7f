package org.echoway.app.guide

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runTest
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.SampleCues
import org.echoway.app.testing.VirtualClock
import org.echoway.core.CueKind
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Test

@OptIn(ExperimentalCoroutinesApi::class)
class SpeechQueueTest {
    private val room = Message.Told(SampleCues.cue(CueKind.ENTERING, ""))
    private val door = Message.Told(SampleCues.cue(CueKind.DOOR, ""))
    private val turn = Message.Told(SampleCues.cue(CueKind.TURN, ""))
    private val unsure = Message.Told(SampleCues.cue(CueKind.UNCERTAIN, ""))
    private val stop = Message.Told(SampleCues.cue(CueKind.STOP, ""))
    private val asked = Message.Unanswerable(NoAnswer.NotRunning)

    private fun speaking(test: suspend TestScope.(SpeechQueue, RecordingVoice) -> Unit) = runTest {
        val clock = VirtualClock(testScheduler)
        val voice = RecordingVoice(clock)
        test(SpeechQueue(voice, clock, backgroundScope), voice)
    }

    @Test fun everyRankGoesBeforeTheNext() = speaking { queue, voice ->
        queue.say("being said", room)
        advanceTimeBy(100)
        queue.say("place", door)
        queue.say("answer", asked)
        queue.say("turn", turn)
        queue.say("lost", unsure)
        queue.say("danger", stop)
        advanceTimeBy(5_000)
        assertEquals(listOf("being said", "danger", "lost", "turn", "answer", "place"), voice.words)
        assertFalse("a place is cut off", voice.heard.first().whole)
    }

    @Test fun aLineIsCutOffOnlyByOneThatMattersMoreAndCannotWait() {
        val lines = listOf("danger" to stop, "lost" to unsure, "turn" to turn, "answer" to asked, "place" to door)
        for ((first, spoken) in lines) for ((second, newcomer) in lines) {
            if (first == second) continue
            speaking { queue, voice ->
                queue.say("$first $first", spoken)
                advanceTimeBy(100)
                queue.say("$second $second", newcomer)
                advanceTimeBy(3_000)
                val cut = newcomer.rank < spoken.rank && second != "answer"
                assertEquals("$second during $first", !cut, voice.heard.first().whole)
            }
        }
    }

    @Test fun aTurnThatWasCutOffByDangerIsNotSaidLate() = speaking { queue, voice ->
        queue.say("turn left now please", turn)
        advanceTimeBy(100)
        queue.say("something ahead of you on your way that is quite near", stop)
        advanceTimeBy(10_000)
        assertEquals(2, voice.words.size)
    }

    @Test fun whatAScreenExplainsIsHushedWhenTheWearerGoesOn() = speaking { queue, voice ->
        queue.say("a long explanation of one thing or other", Message.Explanation(""))
        advanceTimeBy(500)
        queue.hush("explanation")
        queue.say("the next one", Message.Explanation(""))
        advanceTimeBy(5_000)
        assertEquals(listOf(false, true), voice.heard.map { it.whole })
        assertEquals("the next one", voice.words.last())
    }

    @Test fun chatterNeverCutsOffWhatMatters() = speaking { queue, voice ->
        queue.say("belt disconnected now", Message.BeltLost)
        advanceTimeBy(100)
        queue.say("door", door)
        queue.say("answer", asked)
        advanceTimeBy(5_000)
        assertEquals(listOf("belt disconnected now", "answer", "door"), voice.words)
        assertEquals(true, voice.heard.all { it.whole })
    }

    @Test fun staleLinesAreDropped() = speaking { queue, voice ->
        queue.say("a line that takes longer to be spoken than a door stays news", asked)
        advanceTimeBy(10)
        queue.say("door", door)
        advanceTimeBy(20_000)
        assertEquals(1, voice.words.size)
    }

    @Test fun aNewerLineOfTheTopicTakesTheOldOnesPlace() = speaking { queue, voice ->
        queue.say("something long that is being said", asked)
        advanceTimeBy(10)
        queue.say("room one", room)
        queue.say("room two", room)
        advanceTimeBy(10_000)
        assertEquals(listOf("something long that is being said", "room two"), voice.words)
    }

    @Test fun nothingIsSaidTwiceInTenSeconds() = speaking { queue, voice ->
        queue.say("room one", room)
        advanceTimeBy(4_000)
        queue.say("room one", room)
        advanceTimeBy(20_000)
        assertEquals(listOf("room one"), voice.words)
    }

    @Test fun askedAgainIsAnsweredAgain() = speaking { queue, voice ->
        queue.say("answer", asked)
        advanceTimeBy(2_000)
        queue.say("answer", asked)
        advanceTimeBy(2_000)
        assertEquals(listOf("answer", "answer"), voice.words)
    }

    @Test fun aLossThatHappensTwiceIsTheLastWord() = speaking { queue, voice ->
        queue.say("Belt disconnected.", Message.BeltLost)
        advanceTimeBy(2_000)
        queue.say("Belt connected.", Message.BeltBack)
        advanceTimeBy(2_000)
        queue.say("Belt disconnected.", Message.BeltLost)
        advanceTimeBy(15_000)
        assertEquals(listOf("Belt disconnected.", "Belt connected.", "Belt disconnected."), voice.words)
    }

    @Test fun whatCouldNotBeSaidDuringACallIsSaidAfterIt() = speaking { queue, voice ->
        voice.refuse = true
        queue.say("belt lost", Message.BeltLost)
        queue.say("door", door)
        advanceTimeBy(30_000)
        assertEquals(emptyList<String>(), voice.words)
        voice.refuse = false
        advanceTimeBy(5_000)
        assertEquals(listOf("belt lost"), voice.words)
    }
}
