package org.echoway.app.voice

import kotlinx.coroutines.flow.StateFlow
import org.echoway.app.touch.Touch
import org.echoway.core.Language

/** What became of a line. */
enum class Outcome {
    SPOKEN,

    /** Another sound took over half way through. */
    CUT_OFF,

    /** Not now: a call is on, another app keeps the audio, or the engine failed. */
    REFUSED,
}

enum class VoiceStatus {
    STARTING,
    READY,

    /** Speaks English, because the engine does not know the wanted language or there are no words in it. */
    OTHER_LANGUAGE,

    /** No speech engine that answers; lines are tones and touch. */
    NO_ENGINE,
}

/** Something that speaks. */
interface Voice {
    val status: StateFlow<VoiceStatus>

    /**
     * What it is to be given words in: the wanted language where there are words and an engine for it, else English.
     */
    val language: StateFlow<Language>

    /** Speaks a language from now on if it can; null for the phone's own. */
    fun speakIn(language: Language?)

    /**
     * Returns when the line has been spoken or given up; cancelling it silences it at once.
     *
     * @param sign what tells it from others where it cannot be spoken; null for what is not urgent
     */
    suspend fun speak(text: String, sign: Touch? = null): Outcome
}
