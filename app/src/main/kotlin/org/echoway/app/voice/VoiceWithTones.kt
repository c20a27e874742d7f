package org.echoway.app.voice

import kotlinx.coroutines.flow.StateFlow
import org.echoway.app.touch.Touch
import org.echoway.core.Language

/** Sounds that stand for a line on a phone that cannot speak. */
fun interface Tones {
    /** Sounds the rhythm of [sign], or one tone for a line that has none, and returns when it is over or given up. */
    suspend fun play(sign: Touch?): Outcome
}

/** Speaks where the phone can; otherwise tones tell what is urgent, and that there is a line to read on the screen. */
class VoiceWithTones(private val speech: Voice, private val tones: Tones) : Voice {
    override val status: StateFlow<VoiceStatus> get() = speech.status
    override val language: StateFlow<Language> get() = speech.language

    override fun speakIn(language: Language?) = speech.speakIn(language)

    override suspend fun speak(text: String, sign: Touch?): Outcome {
        val outcome = speech.speak(text, sign)
        if (outcome != Outcome.REFUSED || status.value != VoiceStatus.NO_ENGINE) return outcome
        return tones.play(sign)
    }
}
