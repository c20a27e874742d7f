package org.echoway.app.voice

import android.content.Context
import android.media.AudioAttributes
import android.os.Bundle
import android.speech.tts.TextToSpeech
import android.speech.tts.UtteranceProgressListener
import java.util.Locale
import java.util.concurrent.atomic.AtomicLong
import kotlin.coroutines.resume
import kotlinx.coroutines.CancellableContinuation
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.suspendCancellableCoroutine
import kotlinx.coroutines.withTimeoutOrNull
import org.echoway.core.Language

/**
 * The phone's text-to-speech engine, as navigation guidance that other sounds make way for. Speaks the wanted language, or
 * English where there are no words in it or the engine does not know it. Rate, pitch and voice are the system's own. Without
 * an engine it says nothing and [status] tells.
 */
class TtsVoice(context: Context, private val focus: AudioFocus, private val locale: () -> Locale = Locale::getDefault) : Voice {
    private val state = MutableStateFlow(VoiceStatus.STARTING)
    override val status: StateFlow<VoiceStatus> = state.asStateFlow()
    @Volatile private var wanted: Language? = null
    private val spoken = MutableStateFlow(Language.of(locale().language))
    override val language: StateFlow<Language> = spoken.asStateFlow()

    private val ids = AtomicLong()

    @Volatile private var current: Utterance? = null
    private val tts: TextToSpeech = TextToSpeech(context) { result -> onInit(result) }

    override suspend fun speak(text: String): Outcome {
        if (status.first { it != VoiceStatus.STARTING } == VoiceStatus.NO_ENGINE) return Outcome.REFUSED
        if (!focus.request(onLoss = { current?.end(Outcome.CUT_OFF) })) return Outcome.REFUSED
        try {
            // An engine that dies half way through calls back no more; all that is still to be said would wait for it.
            val patience = PATIENCE_MS + PATIENCE_MS_PER_CHARACTER * text.length
            return withTimeoutOrNull(patience) { suspendCancellableCoroutine { start(text, it) } } ?: Outcome.REFUSED
        } finally {
            current = null
            focus.abandon()
        }
    }

    override fun speakIn(language: Language?) {
        if (language == wanted) return
        wanted = language
        if (status.value == VoiceStatus.STARTING) return // onInit() follows
        chooseLanguage()
    }

    fun shutdown() = tts.shutdown()

    private fun start(text: String, continuation: CancellableContinuation<Outcome>) {
        val utterance = Utterance(ids.incrementAndGet().toString(), continuation)
        current = utterance
        continuation.invokeOnCancellation { tts.stop() }
        val queued = tts.speak(text, TextToSpeech.QUEUE_FLUSH, Bundle.EMPTY, utterance.id)
        if (queued != TextToSpeech.SUCCESS) utterance.end(Outcome.REFUSED)
    }

    private fun onInit(result: Int) {
        if (result != TextToSpeech.SUCCESS) {
            state.value = VoiceStatus.NO_ENGINE
            return
        }
        tts.setAudioAttributes(NAVIGATION)
        tts.setOnUtteranceProgressListener(progress)
        chooseLanguage()
    }

    private fun chooseLanguage() {
        // The phone's own locale knows the country, and so the accent.
        val ideal = wanted?.takeIf { it.tag != locale().language }?.let { Locale.forLanguageTag(it.tag) } ?: locale()
        val language = Language.of(ideal.language)
        val able = language.tag == ideal.language && speaks(ideal)
        spoken.value = if (able) language else Language.ENGLISH
        state.value = when {
            able -> VoiceStatus.READY
            speaks(Locale.ENGLISH) -> VoiceStatus.OTHER_LANGUAGE
            else -> VoiceStatus.NO_ENGINE
        }
    }

    private fun speaks(language: Locale) = tts.setLanguage(language) >= TextToSpeech.LANG_AVAILABLE

    private inner class Utterance(val id: String, private val continuation: CancellableContinuation<Outcome>) {
        fun end(outcome: Outcome) {
            if (outcome == Outcome.CUT_OFF) tts.stop()
            synchronized(continuation) { if (continuation.isActive) continuation.resume(outcome) }
        }
    }

    private val progress = object : UtteranceProgressListener() {
        override fun onStart(id: String) = Unit

        override fun onDone(id: String) = finish(id, Outcome.SPOKEN)

        @Deprecated("Replaced by onError(String, Int)", ReplaceWith("onError(id, TextToSpeech.ERROR)"))
        override fun onError(id: String) = finish(id, Outcome.REFUSED)

        override fun onError(id: String, code: Int) = finish(id, Outcome.REFUSED)

        override fun onStop(id: String, interrupted: Boolean) = finish(id, Outcome.CUT_OFF)

        private fun finish(id: String, outcome: Outcome) {
            current?.takeIf { it.id == id }?.end(outcome)
        }
    }

    companion object {
        /** Until an engine begins to speak, and how slow the slowest speaks. */
        private const val PATIENCE_MS = 10_000L
        private const val PATIENCE_MS_PER_CHARACTER = 300L

        /** Guidance: routed and ducked by the system as a navigation prompt. */
        val NAVIGATION: AudioAttributes = AudioAttributes.Builder()
            .setUsage(AudioAttributes.USAGE_ASSISTANCE_NAVIGATION_GUIDANCE)
            .setContentType(AudioAttributes.CONTENT_TYPE_SPEECH)
            .build()
    }
}
