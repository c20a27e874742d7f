package org.echoway.app.guide

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Deferred
import kotlinx.coroutines.async
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.selects.onTimeout
import kotlinx.coroutines.selects.select
import org.echoway.app.Clock
import org.echoway.app.voice.Outcome
import org.echoway.app.voice.Voice

/**
 * Lines that wait to be spoken: by rank, dropped when stale, replaced by newer ones of their topic, never said twice in
 * ten seconds unless asked for. A line is cut off only by one that outranks it and brings danger or loss.
 */
class SpeechQueue(private val voice: Voice, private val clock: Clock) {
    private class Line(val text: String, val message: Message, val sinceS: Double) {
        fun isStale(nowS: Double) = nowS - sinceS > message.validS
    }

    private val inbox = Channel<Line>(Channel.UNLIMITED)
    private val waiting = mutableListOf<Line>()
    private val spoken = mutableMapOf<String, Double>()

    /** Safe from any thread. */
    fun say(text: String, message: Message) {
        inbox.trySend(Line(text, message, clock.nowS()))
    }

    /** Speaks until it is cancelled. */
    suspend fun run() = coroutineScope {
        while (true) {
            drain()
            val line = next()
            when {
                line != null -> speak(line)
                waiting.isEmpty() -> admit(inbox.receive())
                else -> pause()
            }
        }
    }

    private fun drain() {
        while (true) admit(inbox.tryReceive().getOrNull() ?: return)
    }

    private fun admit(line: Line) {
        waiting.removeAll { it.message.topic == line.message.topic }
        waiting += line
    }

    private fun next(): Line? {
        val now = clock.nowS()
        waiting.removeAll { it.isStale(now) }
        spoken.values.removeAll { now - it > REPEAT_AFTER_S }
        // A repetition waits, for what is lost may be lost twice: dropped, it would leave "connected" as the last word.
        // minBy takes the first of equals: the one that has waited longest.
        return waiting.filterNot { it.message.rank != Rank.ASKED && it.text in spoken }
            .minByOrNull { it.message.rank }
            ?.also(waiting::remove)
    }

    private suspend fun CoroutineScope.speak(line: Line) {
        val speaking = async { voice.speak(line.text) }
        when (awaitOrCut(speaking, line)) {
            Outcome.SPOKEN -> spoken[line.text] = clock.nowS()
            Outcome.CUT_OFF -> if (line.message.rank <= Rank.ASKED) putBack(line)
            Outcome.REFUSED -> {
                putBack(line)
                pause()
            }
        }
    }

    /** A newer line of the topic, if one came meanwhile, is the truer one. */
    private fun putBack(line: Line) {
        if (waiting.none { it.message.topic == line.message.topic }) waiting.add(0, line)
    }

    private suspend fun awaitOrCut(speaking: Deferred<Outcome>, line: Line): Outcome {
        while (true) {
            val outcome = select<Outcome?> {
                speaking.onAwait { it }
                inbox.onReceive { newcomer ->
                    admit(newcomer)
                    if (newcomer.message.rank.cutsOff(line.message.rank)) Outcome.CUT_OFF else null
                }
            } ?: continue
            if (outcome == Outcome.CUT_OFF) speaking.cancelAndJoin()
            return outcome
        }
    }

    /** While the voice is not ours (a call, another app) or a repetition is too early, tries again now and then. */
    @OptIn(kotlinx.coroutines.ExperimentalCoroutinesApi::class)
    private suspend fun pause() = select<Unit> {
        onTimeout(RETRY_MS) {}
        inbox.onReceive(::admit)
    }

    companion object {
        const val REPEAT_AFTER_S = 10.0
        private const val RETRY_MS = 1000L
    }
}
