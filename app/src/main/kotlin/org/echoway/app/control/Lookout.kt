package org.echoway.app.control

import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.map
import org.echoway.app.Clock
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Message
import org.echoway.app.settings.Settings

/** Something loud, for whoever is to find the wearer. */
interface Siren {
    /** A second's notice to the wearer. */
    fun warn()

    fun sound(on: Boolean)
}

/**
 * Firefighter mode's alarm for a wearer who has not moved. Runs with the screen off for as long as guidance does;
 * words, vibration and siren come together, for smoke, noise and gloves take each of them away.
 */
class Lookout(private val siren: Siren, private val clock: Clock, private val tell: (Message) -> Unit) {
    private val judged = MutableStateFlow(Stillness.MOVING)
    private var watch: StillnessWatch? = null
    private var toldS = Double.NEGATIVE_INFINITY

    val stillness: StateFlow<Stillness> = judged.asStateFlow()

    /**
     * Watches while firefighter mode is chosen and guidance goes on: without it nobody's movements are seen. Until
     * it is cancelled.
     */
    suspend fun run(states: StateFlow<NavigationState>, settings: Flow<Settings>) {
        var watching = false
        val goesOn = states.map { it is NavigationState.Running }.distinctUntilChanged()
        combine(settings, goesOn) { wanted, on -> if (wanted.firefighter && on) wanted.notMovedAlertS else 0 }
            .distinctUntilChanged()
            .collectLatest { seconds ->
                if (watching && seconds == 0) tell(Message.WatchEnded)
                watching = seconds > 0
                if (watching) watchOver(states, seconds.toDouble())
            }
    }

    /** The wearer, or who found them, ends the alarm. */
    fun cancel() {
        val watch = watch ?: return
        if (judged.value == Stillness.MOVING) return
        watch.cancel(clock.nowS())
        judge(Stillness.MOVING)
        tell(Message.StillCancelled)
    }

    private suspend fun watchOver(states: StateFlow<NavigationState>, alarmAfterS: Double) {
        val watch = StillnessWatch(alarmAfterS, clock.nowS()).also { watch = it }
        tell(Message.NotAPass)
        try {
            while (true) {
                val moved = (states.value as? NavigationState.Running)?.movedS ?: Double.NEGATIVE_INFINITY
                judge(watch.update(clock.nowS(), moved))
                delay(LOOK_MS)
            }
        } finally {
            this.watch = null
            judge(Stillness.MOVING)
        }
    }

    private fun judge(now: Stillness) {
        val before = judged.value
        judged.value = now
        if (before == Stillness.ALARM && now != before) siren.sound(false)
        val due = now != before || clock.nowS() - toldS >= AGAIN_S
        if (now == Stillness.MOVING || !due) return
        toldS = clock.nowS()
        if (now == Stillness.SOON) {
            siren.warn()
            tell(Message.StillSoon)
        } else {
            if (before != now) siren.sound(true)
            tell(Message.StillAlarm)
        }
    }

    private companion object {
        const val LOOK_MS = 500L

        /** A little more than the voice lets pass before the same words. */
        const val AGAIN_S = 12.0
    }
}
