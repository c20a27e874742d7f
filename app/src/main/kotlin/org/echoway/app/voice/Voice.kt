package org.echoway.app.voice

import kotlinx.coroutines.flow.StateFlow

/** What became of a line. */
enum class Outcome {
    SPOKEN,

    /** Another sound took over half way through. */
    CUT_OFF,

    /** Not now: a call is on, or another app keeps the audio. */
    REFUSED,
}

enum class VoiceStatus {
    STARTING,
    READY,

    /** Speaks, but not the phone's language. */
    OTHER_LANGUAGE,

    /** No speech engine; lines are tones and touch. */
    NO_ENGINE,
}

/** Something that speaks. */
interface Voice {
    val status: StateFlow<VoiceStatus>

    /** Returns when the line has been spoken or given up; cancelling it silences it at once. */
    suspend fun speak(text: String): Outcome
}
