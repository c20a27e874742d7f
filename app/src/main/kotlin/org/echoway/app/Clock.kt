package org.echoway.app

import android.os.SystemClock

/** Seconds on one monotonic clock, from which every time in the app comes. */
fun interface Clock {
    fun nowS(): Double

    companion object {
        /** Goes on while the phone sleeps, as sensor events' own time stamps do. */
        val SYSTEM = Clock { SystemClock.elapsedRealtimeNanos() / 1e9 }
    }
}
