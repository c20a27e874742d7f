package org.echoway.app.engine

import java.io.IOException
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.echoway.app.Clock
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.motion.MotionSource
import org.echoway.core.CoreException
import org.echoway.core.CoreSession
import org.echoway.core.MotionHint
import org.echoway.core.Start

/**
 * Hands the belt's bytes to the core and publishes what comes out. Everything that touches the core runs on [thread],
 * which must be a single one; the flow may be observed from anywhere.
 */
class Navigator(private val thread: CoroutineDispatcher, private val clock: Clock) {
    private val published = MutableStateFlow<NavigationState>(NavigationState.Idle)

    /** One new value a firing; what an observer was too slow for is skipped. */
    val state: StateFlow<NavigationState> = published.asStateFlow()

    /** Navigates until it is cancelled. */
    suspend fun run(building: InstalledBuilding, start: Start, source: BeltSource, motion: MotionSource) = withContext(thread) {
        try {
            CoreSession.open(building.folder, clock.nowS(), start).use { session -> Run(building, session).run(source, motion) }
        } catch (e: CoreException) {
            published.value = NavigationState.Failed(e.message.orEmpty())
        } finally {
            if (published.value is NavigationState.Running) published.value = NavigationState.Idle
        }
    }

    private inner class Run(private val building: InstalledBuilding, private val session: CoreSession) {
        private var line = Line.WAITING
        private var health = session.beltHealth

        suspend fun run(source: BeltSource, motion: MotionSource) = coroutineScope {
            publish()
            launch { tick() }
            if (!source.bringsMotion) launch { feedMotion(motion.hints()) }
            try {
                source.events.collect(::onEvent)
            } catch (e: IOException) {
                // A recording that cannot be read. Ending the collection would leave the wearer with silence.
                published.value = NavigationState.Failed(e.message.orEmpty())
                throw CoreException(e.message.orEmpty())
            }
        }

        private suspend fun CoroutineScope.tick() {
            while (isActive) {
                session.onTick(clock.nowS())
                refreshHealth()
                publish()
                delay(TICK_MS)
            }
        }

        private suspend fun feedMotion(hints: Flow<MotionHint>) = hints.collect(session::onMotion)

        private fun onEvent(event: BeltEvent) {
            when (event) {
                is BeltEvent.Bytes -> {
                    if (session.onBytes(event.data, event.arrivalS) > 0) publish()
                    return
                }
                is BeltEvent.Motion -> {
                    session.onMotion(event.hint)
                    return
                }
                BeltEvent.Attached -> moveTo(Line.OPEN) { session.onBeltAttached(clock.nowS()) }
                BeltEvent.Detached -> moveTo(Line.GONE) { session.onBeltDetached(clock.nowS()) }
                BeltEvent.Ended -> moveTo(Line.ENDED) { session.onBeltDetached(clock.nowS()) }
                BeltEvent.PermissionMissing -> moveTo(Line.PERMISSION_MISSING) {}
            }
        }

        private fun moveTo(next: Line, tell: () -> Unit) {
            line = next
            tell()
            refreshHealth()
            publish()
        }

        private fun refreshHealth() {
            health = session.beltHealth
        }

        private fun publish() {
            published.value = NavigationState.Running(building, clock.nowS(), line, health, session.estimate)
        }
    }

    private companion object {
        /** Four times a second: a belt that fell silent is noticed well within the two seconds a wearer is promised. */
        const val TICK_MS = 250L
    }
}
