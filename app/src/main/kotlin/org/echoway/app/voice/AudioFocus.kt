package org.echoway.app.voice

import android.media.AudioFocusRequest
import android.media.AudioManager

/** Leave to make oneself heard. */
interface AudioFocus {
    /** False when the audio is not to be had now. [onLoss] is called when it is taken away. */
    fun request(onLoss: () -> Unit): Boolean

    fun abandon()
}

/**
 * Plays [sound] with the focus held, and gives it back however that ends; [Outcome.REFUSED] when it is not to be had.
 * [onLoss] is called when it is taken away meanwhile, and is to end [sound].
 */
suspend fun AudioFocus.during(onLoss: () -> Unit, sound: suspend () -> Outcome): Outcome {
    if (!request(onLoss)) return Outcome.REFUSED
    try {
        return sound()
    } finally {
        abandon()
    }
}

/** The phone's audio focus; silent during calls, for a wearer on the phone must hear the other side. */
class PhoneAudioFocus(private val manager: AudioManager) : AudioFocus {
    private var held: AudioFocusRequest? = null

    override fun request(onLoss: () -> Unit): Boolean {
        if (manager.mode in CALL_MODES) return false
        val request = AudioFocusRequest.Builder(AudioManager.AUDIOFOCUS_GAIN_TRANSIENT_MAY_DUCK)
            .setAudioAttributes(TtsVoice.NAVIGATION)
            .setOnAudioFocusChangeListener { change -> if (change in LOSSES) onLoss() }
            .build()
        val granted = manager.requestAudioFocus(request) == AudioManager.AUDIOFOCUS_REQUEST_GRANTED
        if (granted) held = request
        return granted
    }

    override fun abandon() {
        held?.let(manager::abandonAudioFocusRequest)
        held = null
    }

    private companion object {
        val CALL_MODES =
            setOf(AudioManager.MODE_RINGTONE, AudioManager.MODE_IN_CALL, AudioManager.MODE_IN_COMMUNICATION)

        /** Ducking is none: a spoken line stays intelligible under it. */
        val LOSSES = setOf(AudioManager.AUDIOFOCUS_LOSS, AudioManager.AUDIOFOCUS_LOSS_TRANSIENT)
    }
}
