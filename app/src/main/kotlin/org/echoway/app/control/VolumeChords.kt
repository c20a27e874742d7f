package org.echoway.app.control

import org.echoway.app.guide.Ask
import org.echoway.app.guide.Asking

/** @property alone what the key asks in firefighter mode, pressed without the other */
enum class VolumeKey(val alone: Ask) { UP(Ask.WHERE_AM_I), DOWN(Ask.WAY_BACK) }

/**
 * Both volume keys together ask; one alone still changes the volume, or asks too where [loneKeysAsk]. Which one was
 * pressed first tells chords apart, and how long both are held:
 *
 * - up, then down: where am I
 * - down, then up: repeat
 * - both for a second: way out
 * - both twice within a second: mute
 *
 * It asks when a key is let go, so that the phone's own shortcut of holding both for three seconds stays the phone's.
 */
class VolumeChords(private val asking: Asking) {
    private val down = mutableListOf<VolumeKey>()
    private var chorded = false
    private var chordAtMs: Long? = null
    private var first = VolumeKey.UP
    private var lastChordAtMs: Long? = null

    /** Whether a key alone asks instead of changing the volume; every key is then taken. */
    var loneKeysAsk = false

    /** Whether both together ask more than the first of them alone. */
    var chordsAsk = true

    /** Returns whether the event is taken; otherwise it is for the volume. */
    fun onKey(key: VolumeKey, pressed: Boolean, timeMs: Long): Boolean {
        val taken = if (pressed) press(key, timeMs) else letGo(key, timeMs)
        return taken || loneKeysAsk
    }

    /**
     * A key that Android takes back (a call came over it, it was half of a screenshot) was let go by nobody,
     * and asks nothing.
     */
    fun onTakenBack(key: VolumeKey) {
        down.remove(key)
        chorded = down.isNotEmpty()
        chordAtMs = null
    }

    private fun letGo(key: VolumeKey, timeMs: Long): Boolean {
        val lone = down.remove(key) && !chorded
        chorded = chorded && down.isNotEmpty()
        if (lone && loneKeysAsk) asking.ask(key.alone)
        val since = chordAtMs ?: return false
        chordAtMs = null
        release(since, timeMs)
        return true
    }

    private fun press(key: VolumeKey, timeMs: Long): Boolean {
        val repeated = key in down
        if (!repeated) down += key
        if (down.size < VolumeKey.entries.size) return false
        if (repeated || chordAtMs != null) return true // held: the volume stays
        chordAtMs = timeMs
        chorded = true
        first = if (key == VolumeKey.DOWN) VolumeKey.UP else VolumeKey.DOWN
        // The second key goes to the volume too: it takes back the step that the first one made.
        return false
    }

    private fun release(sinceMs: Long, nowMs: Long) {
        val held = nowMs - sinceMs
        val twice = lastChordAtMs?.let { sinceMs - it <= TWICE_MS } == true
        lastChordAtMs = if (twice) null else sinceMs
        when {
            held >= TOO_LONG_MS -> Unit
            !chordsAsk -> asking.ask(first.alone)
            held >= LONG_MS -> asking.ask(Ask.WAY_OUT)
            twice -> asking.ask(Ask.MUTE)
            first == VolumeKey.UP -> asking.ask(Ask.WHERE_AM_I)
            else -> asking.ask(Ask.REPEAT)
        }
    }

    companion object {
        const val LONG_MS = 1000L
        const val TWICE_MS = 1000L

        /** The accessibility shortcut of Android fires at three seconds. */
        const val TOO_LONG_MS = 2500L
    }
}
