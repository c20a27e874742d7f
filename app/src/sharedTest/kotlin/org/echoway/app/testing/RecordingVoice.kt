package org.echoway.app.testing

import kotlin.coroutines.cancellation.CancellationException
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import org.echoway.app.Clock
import org.echoway.app.touch.Touch
import org.echoway.app.voice.Outcome
import org.echoway.app.voice.Voice
import org.echoway.app.voice.VoiceStatus
import org.echoway.core.Language

/** Speaks at a usual pace and remembers what was heard, and when. */
class RecordingVoice(private val clock: Clock) : Voice {
    data class Heard(val text: String, val timeS: Double, val whole: Boolean)

    override val status = MutableStateFlow(VoiceStatus.READY)
    override val language = MutableStateFlow(Language.ENGLISH)
    override fun speakIn(language: Language?) {
        this.language.value = language ?: Language.ENGLISH
    }

    val heard = mutableListOf<Heard>()
    val words get() = heard.map { it.text }

    /** What becomes of lines while the audio is not to be had. */
    var refuse = false

    override suspend fun speak(text: String, sign: Touch?): Outcome {
        if (refuse) return Outcome.REFUSED
        val start = clock.nowS()
        try {
            delay(MS_PER_WORD * text.split(' ').size)
        } catch (e: CancellationException) {
            heard += Heard(text, start, whole = false)
            throw e
        }
        heard += Heard(text, start, whole = true)
        return Outcome.SPOKEN
    }

    companion object {
        /** 170 words a minute. */
        const val MS_PER_WORD = 350L
    }
}
