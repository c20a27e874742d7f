package org.echoway.app.voice

import android.media.AudioManager
import android.media.ToneGenerator
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Deferred
import kotlinx.coroutines.withTimeoutOrNull
import org.echoway.app.touch.Length
import org.echoway.app.touch.Strength
import org.echoway.app.touch.Touch
import org.echoway.app.touch.pulses

/** A tone: its pitch (of [ToneGenerator]), how long it sounds, and how long it is silent then, milliseconds. */
data class Beep(val pitch: Int, val soundMs: Long, val restMs: Long)

/** How a sign is heard: in the rhythm in which it is felt, slower, for a speaker is no motor; strength is pitch. */
val Touch?.beeps: List<Beep>
    get() = when (this) {
        null -> listOf(Beep(ToneGenerator.TONE_PROP_ACK, LINE_MS, REST_MS))
        // One tick is for the hand, which feels the next ones.
        Touch.SOMETHING_AHEAD -> List(TICKS) { Beep(pitch(Strength.STRONG), Length.SHORT.ms, Length.SHORT.ms) }
        else -> pulses.map { Beep(pitch(it.strength), maxOf(it.length.ms, SHORTEST_MS), REST_MS) }
    }

private fun pitch(strength: Strength) = when (strength) {
    Strength.SOFT -> ToneGenerator.TONE_DTMF_1
    Strength.MEDIUM -> ToneGenerator.TONE_DTMF_5
    Strength.STRONG -> ToneGenerator.TONE_DTMF_D
}

/**
 * Tones on the volume of media, that other sounds make way for. Quiet where Android has no tone generator left to give,
 * and whenever a voice would be: whoever is on the phone hears the other side.
 */
class PhoneTones(private val focus: AudioFocus) : Tones {
    private val generator by lazy {
        runCatching { ToneGenerator(AudioManager.STREAM_MUSIC, ToneGenerator.MAX_VOLUME) }.getOrNull()
    }

    override suspend fun play(sign: Touch?): Outcome {
        val lost = CompletableDeferred<Outcome>()
        return focus.during(onLoss = { lost.complete(Outcome.CUT_OFF) }) { sound(sign.beeps, lost) }
    }

    /** Plays [beeps] to the end, or until [lost] tells how it ends. */
    private suspend fun sound(beeps: List<Beep>, lost: Deferred<Outcome>): Outcome = try {
        beeps.firstNotNullOfOrNull { beep ->
            generator?.startTone(beep.pitch, beep.soundMs.toInt())
            withTimeoutOrNull(beep.soundMs + beep.restMs) { lost.await() }
        } ?: Outcome.SPOKEN
    } finally {
        generator?.stopTone()
    }
}

private const val LINE_MS = 300L
private const val REST_MS = 150L

/** Shorter ones click. */
private const val SHORTEST_MS = 120L
private const val TICKS = 5
