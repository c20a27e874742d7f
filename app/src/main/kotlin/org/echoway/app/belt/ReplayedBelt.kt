package org.echoway.app.belt

import kotlin.math.ceil
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flow
import org.echoway.app.Clock

/**
 * Plays a recorded walk as if its belt were on the line now: the same sentences, at the same pace.
 *
 * @param load reads the log, once, when something is first asked of it
 */
class ReplayedBelt(private val clock: Clock, private val load: suspend () -> WalkLog) : BeltSource {
    private var loaded: WalkLog? = null

    override val bringsMotion = true

    override suspend fun setup() = log().belt

    override val events: Flow<BeltEvent> = flow {
        val log = log()
        val startS = clock.nowS() - firstTime(log)
        emit(BeltEvent.Attached)
        var sequence = 0
        var statusDueS = Double.NEGATIVE_INFINITY
        val told = between(log, startS).iterator()
        var next = if (told.hasNext()) told.next() else null
        for (firing in log.firings) {
            while (next != null && next.first <= firing.timeS) {
                waitUntil(startS + next.first)
                emit(next.second)
                next = if (told.hasNext()) told.next() else null
            }
            waitUntil(startS + firing.timeS)
            if (firing.timeS >= statusDueS) {
                emit(BeltEvent.Bytes(WireSentence.status(log.belt.sensors, "replay"), startS + firing.timeS))
                statusDueS = firing.timeS + STATUS_PERIOD_S
            }
            emit(BeltEvent.Bytes(WireSentence.range(sequence++, firing.sensor, firing.rangeM), startS + firing.timeS))
        }
        emit(BeltEvent.Ended)
    }

    private suspend fun log() = loaded ?: load().also { loaded = it }

    /** What happens between the firings, in order of time; where the wearer stands before how they move from there. */
    private fun between(log: WalkLog, startS: Double): List<Pair<Double, BeltEvent>> {
        val restarts = log.restarts.map { it.timeS to BeltEvent.Restart(it) }
        val hints = log.hints.map { it.timeS to BeltEvent.Motion(it.copy(timeS = startS + it.timeS)) }
        return (restarts + hints).sortedBy { it.first }
    }

    private suspend fun waitUntil(timeS: Double) {
        val restMs = ceil((timeS - clock.nowS()) * 1000 - ROUNDING_MS).toLong()
        if (restMs > 0) delay(restMs)
    }

    private fun firstTime(log: WalkLog) =
        minOf(log.firings.first().timeS, log.hints.firstOrNull()?.timeS ?: Double.MAX_VALUE)

    private companion object {
        const val STATUS_PERIOD_S = 1.0

        /** So that a time that is a whole millisecond stays one. */
        const val ROUNDING_MS = 1e-6
    }
}
