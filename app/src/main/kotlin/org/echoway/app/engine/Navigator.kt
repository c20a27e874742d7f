package org.echoway.app.engine

import java.io.Closeable
import java.io.IOException
import kotlin.math.abs
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.channels.BufferOverflow
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableSharedFlow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.SharedFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asSharedFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.echoway.app.Clock
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource
import org.echoway.app.belt.LoggedRestart
import org.echoway.app.building.InstalledBuilding
import org.echoway.app.motion.MotionSource
import org.echoway.core.BeltSetup
import org.echoway.core.CoreException
import org.echoway.core.CoreSession
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.MotionHint
import org.echoway.core.Plan
import org.echoway.core.SpeechStyle
import org.echoway.core.Start

/**
 * Hands the belt's bytes to the core and publishes what comes out. Everything that touches the core runs on [thread],
 * which must be a single one; the flow may be observed from anywhere.
 */
class Navigator(private val thread: CoroutineDispatcher, private val clock: Clock) : Core {
    private val published = MutableStateFlow<NavigationState>(NavigationState.Idle)

    private val told = MutableSharedFlow<GuidanceEvent>(
        extraBufferCapacity = EVENTS_IN_FLIGHT, onBufferOverflow = BufferOverflow.DROP_OLDEST,
    )
    private val drawn = MutableStateFlow(Picture())
    private val wishes = Channel<Wish>(WISHES_IN_FLIGHT, BufferOverflow.DROP_OLDEST)

    /** One new value a firing; what an observer was too slow for is skipped. */
    val state: StateFlow<NavigationState> = published.asStateFlow()

    /** What guidance has to say; each is told once. */
    val events: SharedFlow<GuidanceEvent> = told.asSharedFlow()

    /** Way, breadcrumbs, possible places and explained echoes, four times a second while anybody looks. */
    val picture: StateFlow<Picture> = drawn.asStateFlow()

    /** Whether it runs with a belt on the line, heard or awaited, rather than with a recorded walk. */
    @Volatile var isLive = false
        private set

    @Volatile private var style = SpeechStyle()

    override fun ask(wish: Wish) {
        wishes.trySend(wish)
    }

    override fun speakIn(style: SpeechStyle) {
        this.style = style
    }

    /** Navigates until it is cancelled, led as [wish] says from the beginning; [witness] sees what happens. */
    suspend fun run(
        building: InstalledBuilding,
        start: Start,
        source: BeltSource,
        motion: MotionSource,
        witness: Witness? = null,
        wish: Wish.LeadTo? = null,
    ) = withContext(thread) {
        forgetWishes()
        isLive = !source.bringsMotion
        try {
            Run(building, start, source.setup(), source, witness).use { it.run(motion, wish) }
        } catch (e: CoreException) {
            published.value = NavigationState.Failed(NoStart.BUILDING_UNUSABLE, e.message.orEmpty())
        } catch (e: IOException) {
            // To end without a word would leave the wearer with silence.
            published.value = NavigationState.Failed(NoStart.RECORDING_UNREADABLE, e.message.orEmpty())
        } finally {
            isLive = false
            if (published.value is NavigationState.Running) published.value = NavigationState.Idle
            drawn.value = Picture()
        }
    }

    private fun forgetWishes() {
        while (wishes.tryReceive().isSuccess) Unit
    }

    private inner class Run(
        private val building: InstalledBuilding,
        private var start: Start,
        private var belt: BeltSetup,
        private val source: BeltSource,
        private val witness: Witness?,
    ) : Closeable {
        private var session = CoreSession.open(building.folder, clock.nowS(), start, belt)
        private var heardSinceS: Double? = null // from that start on
        private var line = Line.WAITING
        private var health = session.beltHealth
        private var leading: Wish? = null
        private var movedS = clock.nowS()

        suspend fun run(motion: MotionSource, wish: Wish.LeadTo?) = coroutineScope {
            if (wish == null) publish() else grant(wish)
            launch { tick() }
            launch { for (wish in wishes) grant(wish) }
            if (!source.bringsMotion) launch { feedMotion(motion.hints()) }
            source.events.collect(::onEvent)
        }

        private suspend fun CoroutineScope.tick() {
            while (isActive) {
                session.onTick(clock.nowS())
                refreshHealth()
                if (!session.hasDestination) leading = null
                publish()
                if (drawn.subscriptionCount.value > 0) draw()
                delay(TICK_MS)
            }
        }

        private fun draw() {
            drawn.value = Picture(session.route, session.breadcrumbs, session.hypotheses, session.scan)
        }

        private fun grant(wish: Wish) {
            try {
                obey(wish)
                told.tryEmit(GuidanceEvent.Granted(wish))
            } catch (e: CoreException) {
                told.tryEmit(GuidanceEvent.Refused(wish, e.message.orEmpty()))
            }
            publish()
        }

        private fun obey(wish: Wish) {
            when (wish) {
                Wish.WhereAmI -> session.whereAmI()
                Wish.Repeat -> if (!session.repeat()) throw CoreException("there is no instruction that still holds")
                is Wish.LeadTo -> session.setDestination(wish.destination, wish.preferences)
                Wish.BackTrack -> session.backTrack()
                Wish.StopLeading -> session.clearDestination()
                is Wish.StandAt -> restart(wish.start)
                Wish.AllowBelt -> source.askAgain()
            }
            when (wish) {
                is Wish.LeadTo, Wish.BackTrack -> leading = wish
                Wish.StopLeading -> leading = null
                // A destination stays.
                is Wish.StandAt -> if (!session.hasDestination) loseWay()
                Wish.WhereAmI, Wish.Repeat, Wish.AllowBelt -> Unit
            }
        }

        /** A way back ends with the breadcrumbs that it followed. */
        private fun loseWay() {
            if (leading == Wish.BackTrack) told.tryEmit(GuidanceEvent.WayBackLost)
            leading = null
        }

        private fun restart(start: Start) {
            session.restart(start)
            this.start = start
            heardSinceS = null
            witness?.onRestart(start, clock.nowS())
        }

        /** A room that this building does not have is no reason to stop playing. */
        private fun replay(restart: LoggedRestart) = restart.startIn(building.plan)?.let { start ->
            val room = start.room.takeIf { it != Plan.NO_ROOM }
            grant(Wish.StandAt(start, room?.let { Destination(DestinationKind.ROOM, it) }))
        }

        private suspend fun feedMotion(hints: Flow<MotionHint>) = hints.collect(::onMotion)

        private fun onMotion(hint: MotionHint) {
            session.onMotion(hint)
            witness?.onMotion(hint)
            if (hint.isMovement) movedS = clock.nowS()
        }

        private fun onBytes(bytes: BeltEvent.Bytes) {
            if (session.onBytes(bytes.data, bytes.arrivalS) == 0) return
            if (heardSinceS == null) heardSinceS = bytes.arrivalS
            witness?.onFirings(session.beltHealth.sensors)
            witness?.onEstimate(session.estimate)
            publish()
        }

        private fun onEvent(event: BeltEvent) {
            when (event) {
                is BeltEvent.Bytes -> {
                    onBytes(event)
                    return
                }
                is BeltEvent.Motion -> {
                    onMotion(event.hint)
                    return
                }
                is BeltEvent.Restart -> {
                    replay(event.restart)
                    return
                }
                BeltEvent.Attached -> moveTo(Line.OPEN) { session.onBeltAttached(clock.nowS()) }
                BeltEvent.Detached -> moveTo(Line.GONE) { session.onBeltDetached(clock.nowS()) }
                BeltEvent.Ended -> moveTo(Line.ENDED) { session.onBeltDetached(clock.nowS()) }
                BeltEvent.PermissionMissing -> moveTo(Line.PERMISSION_MISSING) {}
                BeltEvent.PermissionRefused -> moveTo(Line.REFUSED) {}
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
            if (health.sensors.size != belt.sensors) wear(belt.copy(sensors = health.sensors.size))
        }

        /** The belt says that it has another number of sensors: so far they were thought to look where they do not. */
        private fun wear(other: BeltSetup) {
            belt = other
            val stillThere = clock.nowS() - (heardSinceS ?: clock.nowS()) < STILL_THERE_S
            // Not from the building's folder: the wearer may have deleted it since.
            session = session.use { it.withBelt(belt, clock.nowS(), if (stillThere) start else Start()) }
            if (!stillThere) told.tryEmit(GuidanceEvent.BeltChanged(belt.sensors))
            (leading as? Wish.LeadTo)?.let(::grant) ?: loseWay()
        }

        override fun close() = session.close()

        private fun publish() {
            val estimate = session.estimate
            if (abs(estimate.speedMps) > WALKING_MPS) movedS = clock.nowS()
            published.value =
                NavigationState.Running(
                    building, clock.nowS(), line, health, estimate, leading, session.obstacleAheadM, movedS, isLive,
                )
            while (true) told.tryEmit(GuidanceEvent.Told(session.nextCue(style) ?: return))
        }
    }

    private companion object {
        /** Four times a second: a belt that fell silent is noticed well within the two seconds a wearer is promised. */
        const val TICK_MS = 250L

        /** Estimates of somebody who stands move a little less. */
        const val WALKING_MPS = 0.3

        /** Whose belt has been heard for so short a time is still near where they began. */
        const val STILL_THERE_S = 5.0
        const val EVENTS_IN_FLIGHT = 64
        const val WISHES_IN_FLIGHT = 8
    }
}
