package org.echoway.app.control

import android.content.Intent
import android.os.Handler
import android.view.KeyEvent
import androidx.core.content.IntentCompat
import androidx.media3.session.MediaSession
import org.echoway.app.guide.Ask
import org.echoway.app.guide.Asking

/**
 * The keys that headsets send. Android would pass on only those that suit what a player does just now ("play" is none
 * while it plays), and Media3 tells two presses of a headset's one button apart at most; here every key asks, and the
 * one button asks by the number of its presses.
 *
 * @param handler of the thread that the session lives on
 */
internal class MediaKeys(private val asking: Asking, private val handler: Handler) : MediaSession.Callback {
    private var presses = 0
    private val countedOut = Runnable {
        val ask = BY_PRESSES[presses - 1]
        presses = 0
        asking.ask(ask)
    }

    override fun onMediaButtonEvent(
        session: MediaSession,
        controllerInfo: MediaSession.ControllerInfo,
        intent: Intent,
    ): Boolean {
        val key = IntentCompat.getParcelableExtra(intent, Intent.EXTRA_KEY_EVENT, KeyEvent::class.java) ?: return false
        if (key.keyCode !in ONE_BUTTON && key.keyCode !in BY_KEY) return false
        // A key that is held repeats itself; it is one press.
        if (key.action == KeyEvent.ACTION_DOWN && key.repeatCount == 0) BY_KEY[key.keyCode]?.let(asking::ask) ?: count()
        return true
    }

    private fun count() {
        presses++
        handler.removeCallbacks(countedOut)
        if (presses == BY_PRESSES.size) countedOut.run() else handler.postDelayed(countedOut, PAUSE_MS)
    }

    fun close() = handler.removeCallbacks(countedOut)

    private companion object {
        val ONE_BUTTON = setOf(KeyEvent.KEYCODE_HEADSETHOOK, KeyEvent.KEYCODE_MEDIA_PLAY_PAUSE)
        val BY_PRESSES = listOf(Ask.WHERE_AM_I, Ask.REPEAT, Ask.WAY_OUT, Ask.START_AGAIN)
        val BY_KEY = mapOf(
            KeyEvent.KEYCODE_MEDIA_PLAY to Ask.WHERE_AM_I,
            KeyEvent.KEYCODE_MEDIA_PAUSE to Ask.WHERE_AM_I,
            KeyEvent.KEYCODE_MEDIA_NEXT to Ask.REPEAT,
            KeyEvent.KEYCODE_MEDIA_PREVIOUS to Ask.WAY_OUT,
            KeyEvent.KEYCODE_MEDIA_STOP to Ask.MUTE,
        )

        /** Who has not pressed again by then has finished. */
        const val PAUSE_MS = 450L
    }
}
