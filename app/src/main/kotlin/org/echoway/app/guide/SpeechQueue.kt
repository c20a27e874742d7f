package org.echoway.app.guide

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Deferred
import kotlinx.coroutines.Job
import kotlinx.coroutines.async
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.launch
import kotlinx.coroutines.selects.onTimeout
import kotlinx.coroutines.selects.select
import org.echoway.app.Clock
import org.echoway.app.voice.Outcome
import org.echoway.app.voice.Voice
import org.echoway.core.Language

/**
 * The one voice: lines that wait to be spoken, by rank, dropped when stale, replaced by newer ones of their topic,
 * never said twice in ten seconds unless asked for. A line is cut off only by one that outranks it and brings danger,
 * loss or a turn. Speaks in [scope] from the first line on.
 */
class SpeechQueue(private val voice: Voice, private val clock: Clock, private val scope: CoroutineScope) {
    /** A line that was said to its end. */
    data class Spoken(val words: String, val message: Message)

    private sealed interface Entry

    private class Line(val text: String, val message: Message, val sinceS: Double) : Entry {
        fun isStale(nowS: Double) = nowS - sinceS > message.validS
    }

    private class Hush(val topic: String) : Entry

    private val inbox = Channel<Entry>(Channel.UNLIMITED)
    private val waiting = mutableListOf<Line>()
    private val spoken = mutableMapOf<String, Double>()
    private var worker: Job? = null

    /** What is to be spoken in: the wanted language where core and engine know it. */
    val language: StateFlow<Language> get() = voice.language

    fun speakIn(language: Language?) = voice.speakIn(language)

    /** Repetitions are not remembered: asked twice, the same line comes twice. */
    @Volatile var lastSpoken: Spoken? = null
        private set

    /** From the thread of [scope]. */
    fun say(text: String, message: Message) {
        inbox.trySend(Line(text, message, clock.nowS()))
        awaken()
    }

    /** Gives up what waits or is being said on a topic: the wearer has moved on. */
    fun hush(topic: String) {
        inbox.trySend(Hush(topic))
        awaken()
    }

    private fun awaken() {
        if (worker?.isActive != true) worker = scope.launch { run() }
    }

    private suspend fun run() = coroutineScope {
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

    private fun admit(entry: Entry) {
        waiting.removeAll {
            it.message.topic == (entry as? Line)?.message?.topic || it.message.topic == (entry as? Hush)?.topic
        }
        if (entry is Line) waiting += entry
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
        val speaking = async { voice.speak(line.text, line.message.sign) }
        when (awaitOrCut(speaking, line)) {
            Outcome.SPOKEN -> remember(line)
            Outcome.CUT_OFF -> if (line.message.rank <= Rank.ASKED) putBack(line)
            Outcome.REFUSED -> {
                putBack(line)
                pause()
            }
            null -> Unit
        }
    }

    private fun remember(line: Line) {
        spoken[line.text] = clock.nowS()
        if (line.message is Message.Again || line.message is Message.NothingToRepeat) return
        lastSpoken = Spoken(line.text, line.message)
    }

    /** A newer line of the topic, if one came meanwhile, is the truer one. */
    private fun putBack(line: Line) {
        if (waiting.none { it.message.topic == line.message.topic }) waiting.add(0, line)
    }

    /** Null when the line was hushed. */
    private suspend fun awaitOrCut(speaking: Deferred<Outcome>, line: Line): Outcome? {
        while (true) {
            val end = select<End?> {
                speaking.onAwait { End(it) }
                inbox.onReceive { entry ->
                    admit(entry)
                    when {
                        entry is Hush && entry.topic == line.message.topic -> End(null)
                        entry is Line && entry.message.rank.cutsOff(line.message.rank) -> End(Outcome.CUT_OFF)
                        else -> null
                    }
                }
            } ?: continue
            if (speaking.isActive) speaking.cancelAndJoin()
            return end.outcome
        }
    }

    private class End(val outcome: Outcome?)

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
