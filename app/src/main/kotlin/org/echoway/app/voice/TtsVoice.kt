package org.echoway.app.voice

import android.content.Context
import android.media.AudioAttributes
import android.os.Bundle
import android.os.Handler
import android.os.Looper
import android.os.SystemClock
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
import org.echoway.app.touch.Touch
import org.echoway.core.Language

/**
 * The phone's text-to-speech engine, as navigation guidance that other sounds make way for. Speaks the wanted language,
 * or English where there are no words in it or the engine does not know it. Rate, pitch and voice are the system's own.
 * Without an engine, or with one that does not answer, it says nothing and [status] tells; each line then looks for an
 * engine anew. Used from the main thread.
 */
class TtsVoice(
    private val context: Context,
    private val focus: AudioFocus,
    private val locale: () -> Locale = Locale::getDefault,
) : Voice {
    private val state = MutableStateFlow(VoiceStatus.STARTING)
    override val status: StateFlow<VoiceStatus> = state.asStateFlow()
    @Volatile private var wanted: Language? = null
    private val spoken = MutableStateFlow(Language.of(locale().language))
    override val language: StateFlow<Language> = spoken.asStateFlow()

    private val ids = AtomicLong()

    @Volatile private var current: Utterance? = null
    private val patience = Handler(Looper.getMainLooper())
    private val giveUp = Runnable { if (state.value == VoiceStatus.STARTING) state.value = VoiceStatus.NO_ENGINE }
    private lateinit var tts: TextToSpeech
    private var connections = 0
    private var soughtMs = 0L
    private var answered = false
    private var bound = false

    @Volatile private var failures = 0

    init {
        connect()
    }

    override suspend fun speak(text: String, sign: Touch?): Outcome {
        if (status.first { it != VoiceStatus.STARTING } == VoiceStatus.NO_ENGINE) {
            if (SystemClock.elapsedRealtime() - soughtMs >= if (answered) SEEK_AGAIN_MS else UNANSWERED_MS) connect()
            return Outcome.REFUSED
        }
        return focus.during(onLoss = { current?.end(Outcome.CUT_OFF) }) { utter(text) }
    }

    private suspend fun utter(text: String): Outcome = try {
        // An engine that dies half way through calls back no more; all that is still to be said would wait for it.
        val patience = PATIENCE_MS + PATIENCE_MS_PER_CHARACTER * text.length
        withTimeoutOrNull(patience) { suspendCancellableCoroutine { start(text, it) } }
            ?: Outcome.REFUSED.also { onFailure() }
    } finally {
        current = null
    }

    override fun speakIn(language: Language?) {
        if (language == wanted) return
        wanted = language
        // Words that nobody speaks are read on the screen; when an engine comes up it decides.
        if (bound) chooseLanguage() else spoken.value = language ?: Language.of(locale().language)
    }

    /** Binds an engine. One that was bound before is let go: it does not answer. */
    private fun connect() {
        if (connections > 0) tts.shutdown()
        val connection = ++connections
        soughtMs = SystemClock.elapsedRealtime()
        answered = false
        bound = false
        patience.removeCallbacks(giveUp)
        patience.postDelayed(giveUp, CONNECTION_MS)
        // Android may call back before the constructor returns, when there is no engine at all.
        tts = TextToSpeech(context) { result -> if (connection == connections) onInit(result) }
    }

    /** The engine died or fails. A new one is waited for; when that fails too, tones must do until one speaks. */
    private fun onFailure() {
        state.value = if (++failures > 1) VoiceStatus.NO_ENGINE else VoiceStatus.STARTING
        connect()
    }

    private fun start(text: String, continuation: CancellableContinuation<Outcome>) {
        val utterance = Utterance(ids.incrementAndGet().toString(), continuation)
        current = utterance
        continuation.invokeOnCancellation { tts.stop() }
        val queued = tts.speak(text, TextToSpeech.QUEUE_FLUSH, Bundle.EMPTY, utterance.id)
        if (queued != TextToSpeech.SUCCESS) {
            onFailure()
            utterance.end(Outcome.REFUSED)
        }
    }

    private fun onInit(result: Int) {
        answered = true
        if (result != TextToSpeech.SUCCESS) {
            state.value = VoiceStatus.NO_ENGINE
            return
        }
        bound = true
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

    /** What the engine tells of the lines that it was given. */
    internal val progress = object : UtteranceProgressListener() {
        override fun onStart(id: String) = Unit

        override fun onDone(id: String) {
            failures = 0
            finish(id, Outcome.SPOKEN)
        }

        @Deprecated("Replaced by onError(String, Int)", ReplaceWith("onError(id, TextToSpeech.ERROR)"))
        override fun onError(id: String) = fail(id)

        override fun onError(id: String, code: Int) = fail(id)

        override fun onStop(id: String, interrupted: Boolean) = finish(id, Outcome.CUT_OFF)

        private fun fail(id: String) {
            patience.post {
                if (current?.id == id) onFailure()
                finish(id, Outcome.REFUSED)
            }
        }

        private fun finish(id: String, outcome: Outcome) {
            current?.takeIf { it.id == id }?.end(outcome)
        }
    }

    companion object {
        /** Until an engine begins to speak, and how slow the slowest speaks. */
        private const val PATIENCE_MS = 10_000L
        private const val PATIENCE_MS_PER_CHARACTER = 300L

        /** How long an engine may take to come up before lines are tones. It may still come. */
        private const val CONNECTION_MS = 5_000L

        /**
         * How soon an engine is looked for again, when there is a line to say; later while a slow one may yet come up.
         */
        private const val SEEK_AGAIN_MS = 5_000L
        private const val UNANSWERED_MS = 30_000L

        /** Guidance: routed and ducked by the system as a navigation prompt. */
        val NAVIGATION: AudioAttributes = AudioAttributes.Builder()
            .setUsage(AudioAttributes.USAGE_ASSISTANCE_NAVIGATION_GUIDANCE)
            .setContentType(AudioAttributes.CONTENT_TYPE_SPEECH)
            .build()
    }
}
