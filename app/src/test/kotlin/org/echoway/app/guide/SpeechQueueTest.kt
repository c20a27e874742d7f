package org.echoway.app.guide

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.advanceTimeBy
import kotlinx.coroutines.test.runTest
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.SamplePlan
import org.echoway.app.testing.VirtualClock
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Test

@OptIn(ExperimentalCoroutinesApi::class)
class SpeechQueueTest {
    private val room = Message.RoomEntered(SamplePlan.office)
    private val door = Message.DoorNear(Seen(Direction.AHEAD, 1.0, 0.1))
    private val asked = Message.WhereAmI(Answer.NotRunning)

    private fun speaking(test: suspend TestScope.(SpeechQueue, RecordingVoice) -> Unit) = runTest {
        val clock = VirtualClock(testScheduler)
        val voice = RecordingVoice(clock)
        val queue = SpeechQueue(voice, clock)
        backgroundScope.launch { queue.run() }
        test(queue, voice)
    }

    @Test fun lossComesBeforeAnswersAndAnswersBeforePlaces() = speaking { queue, voice ->
        queue.say("being said", room)
        advanceTimeBy(100)
        queue.say("place", door)
        queue.say("answer", asked)
        queue.say("lost", Message.Unsure)
        advanceTimeBy(5_000)
        assertEquals(listOf("being said", "lost", "answer", "place"), voice.words)
        assertFalse("loss cuts a place off", voice.heard.first().whole)
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
        queue.say("a line that takes very much longer to be spoken than a door stays news", asked)
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
