package org.echoway.app.service

import android.os.PowerManager
import org.echoway.app.Clock

/** Keeps the processor awake while the belt talks, and lets it sleep a little after it has stopped. */
class IdleWakeLock(private val lock: PowerManager.WakeLock, private val clock: Clock) {
    private var busyUntilS = Double.NEGATIVE_INFINITY
    private var renewAtS = Double.NEGATIVE_INFINITY

    init {
        lock.setReferenceCounted(false)
    }

    /** Call it as states come: several times a second. */
    fun update(busy: Boolean) {
        val now = clock.nowS()
        if (busy) busyUntilS = now + LINGER_S
        when {
            now > busyUntilS -> release()
            now >= renewAtS || !lock.isHeld -> {
                // The limit is for an app that hangs: a lock is never left behind for good.
                lock.acquire(LIMIT_MS)
                renewAtS = now + LIMIT_MS / 2000.0
            }
        }
    }

    fun release() {
        if (lock.isHeld) lock.release()
    }

    companion object {
        /** Long enough for a belt that is pulled out and put back to be noticed without the screen. */
        const val LINGER_S = 60.0
        private const val LIMIT_MS = 600_000L
    }
}
