package org.echoway.app.voice

import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.first
import org.echoway.core.Language

/** A sound that stands for a line on a phone that cannot speak. */
fun interface Tones {
    fun play()
}

/** Speaks where the phone can; otherwise a tone says that there is a line to read on the screen. */
class VoiceWithTones(private val speech: Voice, private val tones: Tones) : Voice {
    override val status: StateFlow<VoiceStatus> get() = speech.status
    override val language: StateFlow<Language> get() = speech.language

    override fun speakIn(language: Language?) = speech.speakIn(language)

    override suspend fun speak(text: String): Outcome {
        if (status.first { it != VoiceStatus.STARTING } != VoiceStatus.NO_ENGINE) return speech.speak(text)
        tones.play()
        delay(TONE_MS)
        return Outcome.SPOKEN
    }

    private companion object {
        const val TONE_MS = 600L
    }
}
