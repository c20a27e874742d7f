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
import org.echoway.app.touch.Touch
import org.echoway.core.Language
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNotSame
import org.junit.Assert.assertSame
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowLooper
import org.robolectric.shadows.ShadowTextToSpeech
import org.robolectric.shadows.ShadowToneGenerator

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

    private fun saying(voice: Voice, text: String, sign: Touch? = null): Deferred<Outcome> =
        CoroutineScope(Dispatchers.Main.immediate).async(start = CoroutineStart.UNDISPATCHED) {
            voice.speak(text, sign)
        }

    private fun done(line: Deferred<Outcome>): Outcome {
        ShadowLooper.idleMainLooper()
        assertTrue("the line came to an end", line.isCompleted)
        return line.getCompleted()
    }

    @After fun tidy() {
        ShadowTextToSpeech.reset()
        ShadowToneGenerator.reset()
    }

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
        val dead = ShadowTextToSpeech.getLastTextToSpeechInstance()
        dead.setOnUtteranceProgressListener(Unheard)
        val line = saying(voice, "Turn left.")
        ShadowLooper.idleMainLooper(5, TimeUnit.SECONDS)
        assertFalse("it may yet speak", line.isCompleted)
        ShadowLooper.idleMainLooper(30, TimeUnit.SECONDS)
        assertEquals(Outcome.REFUSED, done(line))
        assertTrue(shadowOf(dead).isStopped)
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
        voice(
            Locale.forLanguageTag("de-AT"), listOf(Locale.forLanguageTag("de-AT"), Locale.GERMAN, Locale.ENGLISH),
        ).speakIn(Language.GERMAN)
        assertEquals("AT", engine().currentLanguage.country)
    }

    private val signs = mutableListOf<Touch?>()

    /** [speech], with tones that only remember what they stood for. */
    private fun withTones(speech: Voice) = VoiceWithTones(speech) { sign -> Outcome.SPOKEN.also { signs += sign } }

    private fun unanswered() = TtsVoice(context, PhoneAudioFocus(audio)) { Locale.US }

    @Test fun withoutAnEngineTonesSoundInstead() {
        val speech = unanswered()
        engine().onInitListener.onInit(TextToSpeech.ERROR)
        assertEquals(VoiceStatus.NO_ENGINE, speech.status.value)
        assertEquals(Outcome.SPOKEN, done(saying(withTones(speech), "Turn left.", Touch.LEFT)))
        assertEquals(listOf<Touch?>(Touch.LEFT), signs)
    }

    private fun voiceOfTonesAlone(): Voice {
        val speech = unanswered()
        engine().onInitListener.onInit(TextToSpeech.ERROR)
        return VoiceWithTones(speech, PhoneTones(PhoneAudioFocus(audio)))
    }

    @Test fun tonesAreSilentDuringACallAndTheLineWaits() {
        val voice = voiceOfTonesAlone()
        audio.mode = AudioManager.MODE_IN_CALL
        assertEquals(Outcome.REFUSED, done(saying(voice, "Turn left.", Touch.LEFT)))
        assertEquals(emptyList<Any>(), ShadowToneGenerator.getPlayedTones())
        audio.mode = AudioManager.MODE_NORMAL
        val line = saying(voice, "Turn left.", Touch.LEFT)
        ShadowLooper.idleMainLooper(5, TimeUnit.SECONDS)
        assertEquals(Outcome.SPOKEN, done(line))
        assertEquals("long, short", 2, ShadowToneGenerator.getPlayedTones().size)
        val request = shadowOf(audio).lastAudioFocusRequest.audioFocusRequest
        assertEquals("focus is given back", request, shadowOf(audio).lastAbandonedAudioFocusRequest)
    }

    @Test fun tonesEndWhenThePhoneRings() {
        val line = saying(voiceOfTonesAlone(), "Belt disconnected.", Touch.BELT_LOST)
        ShadowLooper.idleMainLooper()
        shadowOf(audio).lastAudioFocusRequest.listener.onAudioFocusChange(AudioManager.AUDIOFOCUS_LOSS_TRANSIENT)
        assertEquals(Outcome.CUT_OFF, done(line))
        assertEquals("one of three", 1, ShadowToneGenerator.getPlayedTones().size)
    }

    @Test fun anEngineThatIsNeverReachedHoldsNoLineUpForLong() {
        val line = saying(withTones(unanswered()), "Belt disconnected.", Touch.BELT_LOST)
        ShadowLooper.idleMainLooper(2, TimeUnit.SECONDS)
        assertFalse("it may yet come up", line.isCompleted)
        ShadowLooper.idleMainLooper(4, TimeUnit.SECONDS)
        assertEquals(Outcome.SPOKEN, done(line))
        assertEquals(listOf<Touch?>(Touch.BELT_LOST), signs)
    }

    @Test fun anEngineThatComesUpLateSpeaks() {
        listOf(Locale.US, Locale.ENGLISH).forEach(ShadowTextToSpeech::addLanguageAvailability)
        val speech = unanswered()
        val slow = ShadowTextToSpeech.getLastTextToSpeechInstance()
        ShadowLooper.idleMainLooper(6, TimeUnit.SECONDS)
        assertEquals(VoiceStatus.NO_ENGINE, speech.status.value)
        done(saying(withTones(speech), "Turn left.", Touch.LEFT))
        engine().onInitListener.onInit(TextToSpeech.SUCCESS)
        assertSame("it was not given up for another", slow, ShadowTextToSpeech.getLastTextToSpeechInstance())
        assertEquals(VoiceStatus.READY, speech.status.value)
        assertEquals(Outcome.SPOKEN, done(saying(withTones(speech), "Turn right.", Touch.RIGHT)))
        assertEquals("Turn right.", engine().lastSpokenText)
        assertEquals(listOf<Touch?>(Touch.LEFT), signs)
    }

    @Test fun anEngineThatIsInstalledLaterIsFound() {
        listOf(Locale.US, Locale.ENGLISH).forEach(ShadowTextToSpeech::addLanguageAvailability)
        val speech = unanswered()
        engine().onInitListener.onInit(TextToSpeech.ERROR)
        val none = ShadowTextToSpeech.getLastTextToSpeechInstance()
        done(saying(withTones(speech), "Turn left.", Touch.LEFT))
        assertSame("not at once again", none, ShadowTextToSpeech.getLastTextToSpeechInstance())
        ShadowLooper.idleMainLooper(10, TimeUnit.SECONDS)
        done(saying(withTones(speech), "Turn right.", Touch.RIGHT))
        assertNotSame(none, ShadowTextToSpeech.getLastTextToSpeechInstance())
        engine().onInitListener.onInit(TextToSpeech.SUCCESS)
        done(saying(withTones(speech), "Room 2.", Touch.ROOM_ENTERED))
        assertEquals("Room 2.", engine().lastSpokenText)
        assertEquals(listOf<Touch?>(Touch.LEFT, Touch.RIGHT), signs)
    }

    @Test fun anEngineThatDiesIsBoundAnewAndTonesStandInWhenThatDiesToo() {
        val speech = voice()
        val voice = withTones(speech)
        fun dies(): Outcome {
            ShadowTextToSpeech.getLastTextToSpeechInstance().setOnUtteranceProgressListener(Unheard)
            val line = saying(voice, "Stop.", Touch.SOMETHING_AHEAD)
            ShadowLooper.idleMainLooper(30, TimeUnit.SECONDS)
            return done(line)
        }
        val first = ShadowTextToSpeech.getLastTextToSpeechInstance()
        assertEquals("said again while it holds", Outcome.REFUSED, dies())
        assertNotSame(first, ShadowTextToSpeech.getLastTextToSpeechInstance())
        engine().onInitListener.onInit(TextToSpeech.SUCCESS)
        assertEquals(VoiceStatus.READY, speech.status.value)
        assertEquals(Outcome.SPOKEN, dies())
        assertEquals(listOf<Touch?>(Touch.SOMETHING_AHEAD), signs)
    }

    @Test fun anEngineThatCannotSayAnythingIsStoodInForByTones() {
        val speech = voice()
        val voice = withTones(speech)
        var lines = 0
        fun fails(): Outcome {
            ShadowTextToSpeech.getLastTextToSpeechInstance().setOnUtteranceProgressListener(Unheard)
            val line = saying(voice, "Stop.", Touch.SOMETHING_AHEAD)
            speech.progress.onError("${++lines}", TextToSpeech.ERROR_SYNTHESIS)
            return done(line)
        }
        assertEquals(Outcome.REFUSED, fails())
        engine().onInitListener.onInit(TextToSpeech.SUCCESS)
        assertEquals(Outcome.SPOKEN, fails())
    }

    @Test fun withoutAnEngineTheWordsOnTheScreenAreInTheChosenLanguage() {
        val speech = unanswered()
        engine().onInitListener.onInit(TextToSpeech.ERROR)
        speech.speakIn(Language.GERMAN)
        assertEquals(Language.GERMAN to VoiceStatus.NO_ENGINE, speech.language.value to speech.status.value)
    }

    @Test fun urgentTonesAreToldApart() {
        val urgent = Touch.entries - Touch.ROOM_ENTERED
        assertEquals(urgent.size + 1, (urgent + null).map { it.beeps }.toSet().size)
        assertTrue("long enough to hear", (Touch.entries + null).all { sign -> sign.beeps.all { it.soundMs >= 90 } })
    }
}
