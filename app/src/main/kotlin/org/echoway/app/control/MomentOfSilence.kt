package org.echoway.app.control

import android.media.AudioAttributes
import android.media.AudioFormat
import android.media.AudioTrack

/** Makes Android hand its media buttons to this app. */
fun interface Presence {
    fun claim()
}

/**
 * Android sends media buttons to the app that was heard last, and the speech engine is another app. A tenth of a second
 * of silence of our own makes us the one.
 */
class MomentOfSilence : Presence {
    override fun claim() {
        val samples = ShortArray(SAMPLE_RATE / 10)
        val silence = try {
            track(samples.size)
        } catch (_: UnsupportedOperationException) {
            return // no audio output at all: then no headset has buttons either
        }
        silence.write(samples, 0, samples.size)
        silence.notificationMarkerPosition = samples.size
        silence.setPlaybackPositionUpdateListener(object : AudioTrack.OnPlaybackPositionUpdateListener {
            override fun onMarkerReached(track: AudioTrack) = track.release()

            override fun onPeriodicNotification(track: AudioTrack) = Unit
        })
        silence.play()
    }

    private fun track(samples: Int) = AudioTrack.Builder()
        .setAudioAttributes(AudioAttributes.Builder().setUsage(AudioAttributes.USAGE_MEDIA).build())
        .setAudioFormat(
            AudioFormat.Builder().setEncoding(AudioFormat.ENCODING_PCM_16BIT).setSampleRate(SAMPLE_RATE)
                .setChannelMask(AudioFormat.CHANNEL_OUT_MONO).build(),
        )
        .setTransferMode(AudioTrack.MODE_STATIC)
        .setBufferSizeInBytes(samples * Short.SIZE_BYTES)
        .build()

    private companion object {
        const val SAMPLE_RATE = 8000
    }
}
