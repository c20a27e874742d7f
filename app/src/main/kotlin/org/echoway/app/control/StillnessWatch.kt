package org.echoway.app.control

/** How the watch over a wearer who may not move stands. */
enum class Stillness {
    MOVING,

    /** Not moved for a while: the alarm follows unless they move. */
    SOON,

    /** The alarm is on. Only a hand on "cancel" ends it: somebody else may have moved the wearer. */
    ALARM,
}

/**
 * Watches over a wearer who does not move: a warning [WARNING_S] before the alarm, which motion takes back; then the
 * alarm, which it does not. No certified alarm (PASS): see docs/voice-and-touch.md.
 *
 * @param alarmAfterS seconds without a movement until the alarm; 0 for never
 */
class StillnessWatch(private val alarmAfterS: Double, startS: Double) {
    private var countFromS = startS
    private var alarmed = false

    /** [movedS]: when the wearer last moved for sure. */
    fun update(nowS: Double, movedS: Double): Stillness {
        countFromS = maxOf(countFromS, movedS)
        val still = nowS - countFromS
        if (alarmAfterS > 0 && still >= alarmAfterS) alarmed = true
        return when {
            alarmed -> Stillness.ALARM
            alarmAfterS > 0 && still >= alarmAfterS - minOf(WARNING_S, alarmAfterS / 2) -> Stillness.SOON
            else -> Stillness.MOVING
        }
    }

    /** Ends the alarm and counts anew. */
    fun cancel(nowS: Double) {
        alarmed = false
        countFromS = nowS
    }

    companion object {
        const val WARNING_S = 10.0
    }
}
