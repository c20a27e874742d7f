package org.echoway.app.voice

import android.content.Context
import android.media.AudioManager
import android.speech.tts.TextToSpeech
import android.speech.tts.UtteranceProgressListener
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.Locale
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Deferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.async
import org.echoway.core.Language
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowLooper
import org.robolectric.shadows.ShadowTextToSpeech

@RunWith(AndroidJUnit4::class)
@OptIn(ExperimentalCoroutinesApi::class)
class TtsVoiceTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val audio = context.getSystemService(AudioManager::class.java)

    private fun voice(language: Locale = Locale.US, known: List<Locale> = listOf(Locale.US, Locale.ENGLISH)): TtsVoice {
        known.forEach(ShadowTextToSpeech::addLanguageAvailability)
        return TtsVoice(context, PhoneAudioFocus(audio)) { language }.also {
            engine().onInitListener.onInit(TextToSpeech.SUCCESS)
        }
    }

    private fun engine() = shadowOf(ShadowTextToSpeech.getLastTextToSpeechInstance())

    private fun saying(voice: Voice, text: String): Deferred<Outcome> =
        CoroutineScope(Dispatchers.Main.immediate).async(start = CoroutineStart.UNDISPATCHED) { voice.speak(text) }

    private fun done(line: Deferred<Outcome>): Outcome {
        ShadowLooper.idleMainLooper()
        assertTrue("the line came to an end", line.isCompleted)
        return line.getCompleted()
    }

    @After fun tidy() = ShadowTextToSpeech.reset()

    @Test fun speaksAsGuidanceThatOtherSoundsDuckFor() {
        val line = saying(voice(), "Turn left.")
        assertEquals("Turn left.", engine().lastSpokenText)
        val request = shadowOf(audio).lastAudioFocusRequest.audioFocusRequest
        assertEquals(AudioManager.AUDIOFOCUS_GAIN_TRANSIENT_MAY_DUCK, request.focusGain)
        assertEquals(TtsVoice.NAVIGATION.usage, request.audioAttributes.usage)
        assertEquals(Outcome.SPOKEN, done(line))
        assertEquals("focus is given back", request, shadowOf(audio).lastAbandonedAudioFocusRequest)
    }

    @Test fun isSilentDuringACall() {
        audio.mode = AudioManager.MODE_IN_CALL
        assertEquals(Outcome.REFUSED, done(saying(voice(), "Turn left.")))
        assertEquals(null, engine().lastSpokenText)
        audio.mode = AudioManager.MODE_NORMAL
    }

    @Test fun isRefusedWhenAnotherAppKeepsTheAudio() {
        shadowOf(audio).setNextFocusRequestResponse(AudioManager.AUDIOFOCUS_REQUEST_FAILED)
        assertEquals(Outcome.REFUSED, done(saying(voice(), "Turn left.")))
    }

    @Test fun stopsWhenAnotherAppTakesTheAudio() {
        val line = saying(voice(), "Turn left.")
        shadowOf(audio).lastAudioFocusRequest.listener.onAudioFocusChange(AudioManager.AUDIOFOCUS_LOSS_TRANSIENT)
        assertEquals(Outcome.CUT_OFF, done(line))
        assertTrue(engine().isStopped)
    }

    @Test fun anEngineThatDiesHalfWayThroughHoldsUpNoOtherLine() {
        val voice = voice()
        ShadowTextToSpeech.getLastTextToSpeechInstance().setOnUtteranceProgressListener(Unheard)
        val line = saying(voice, "Turn left.")
        ShadowLooper.idleMainLooper(5, TimeUnit.SECONDS)
        assertFalse("it may yet speak", line.isCompleted)
        ShadowLooper.idleMainLooper(30, TimeUnit.SECONDS)
        assertEquals(Outcome.REFUSED, done(line))
        assertTrue(engine().isStopped)
    }

    /** Takes the engine's word, and does not pass it on. */
    private object Unheard : UtteranceProgressListener() {
        override fun onStart(id: String) = Unit

        override fun onDone(id: String) = Unit

        @Deprecated("Replaced by onError(String, Int)")
        override fun onError(id: String) = Unit
    }

    @Test fun cancellingSilencesIt() {
        val line = saying(voice(), "Door left, six feet.")
        line.cancel()
        assertTrue(engine().isStopped)
    }

    @Test fun speaksEnglishWhereTheEngineDoesNotKnowTheLanguage() {
        assertEquals(VoiceStatus.OTHER_LANGUAGE, voice(Locale("cy")).status.value)
    }

    @Test fun speaksTheLanguageThatTheWearerChoseAndEnglishWhereTheEngineLacksIt() {
        val voice = voice(Locale.US, listOf(Locale.US, Locale.ENGLISH, Locale.GERMAN))
        fun chosen(language: Language?): Pair<Language, VoiceStatus> {
            voice.speakIn(language)
            return voice.language.value to voice.status.value
        }
        assertEquals(Language.ENGLISH to VoiceStatus.READY, chosen(null))
        assertEquals(Language.GERMAN to VoiceStatus.READY, chosen(Language.GERMAN))
        assertEquals(Locale.GERMAN, engine().currentLanguage)
        assertEquals(Language.ENGLISH to VoiceStatus.OTHER_LANGUAGE, chosen(Language.FRENCH))
        assertEquals("English words are spoken by an English voice", "en", engine().currentLanguage.language)
        assertEquals(Language.ENGLISH to VoiceStatus.READY, chosen(null))
    }

    @Test fun anEngineForALanguageWithoutWordsSpeaksEnglish() {
        val voice = voice(Locale.ITALIAN, listOf(Locale.ITALIAN, Locale.ENGLISH))
        assertEquals(Language.ENGLISH, voice.language.value)
        assertEquals(VoiceStatus.OTHER_LANGUAGE, voice.status.value)
        assertEquals("en", engine().currentLanguage.language)
    }

    @Test fun theAccentIsThePhones() {
        voice(Locale.forLanguageTag("de-AT"), listOf(Locale.forLanguageTag("de-AT"), Locale.GERMAN, Locale.ENGLISH)).speakIn(Language.GERMAN)
        assertEquals("AT", engine().currentLanguage.country)
    }

    @Test fun withoutAnEngineAToneSoundsInstead() {
        val speech = TtsVoice(context, PhoneAudioFocus(audio)) { Locale.US }
        engine().onInitListener.onInit(TextToSpeech.ERROR)
        assertEquals(VoiceStatus.NO_ENGINE, speech.status.value)
        var tones = 0
        val line = saying(VoiceWithTones(speech) { tones++ }, "Belt disconnected.")
        ShadowLooper.idleMainLooper(1, TimeUnit.SECONDS)
        assertEquals(Outcome.SPOKEN, line.getCompleted())
        assertEquals(1, tones)
        assertFalse(line.isCancelled)
    }
}
