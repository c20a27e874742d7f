package org.echoway.core

import java.io.Closeable
import java.io.File
import java.nio.ByteBuffer
import java.util.concurrent.atomic.AtomicLong
import kotlin.math.abs

/**
 * The belt as it is configured. Defaults: the prototype with fifteen sensors, 0.15 m around the wearer's axis.
 *
 * @property beamRad full angle within which a plane wall answers
 * @property slotS time between two firings
 * @property temperatureC of the air at the start
 */
data class BeltSetup(
    val sensors: Int = 15,
    val radiusM: Double = 0.15,
    val beamRad: Double? = null,
    val slotS: Double? = null,
    val temperatureC: Double? = null,
)

/**
 * What is known of the wearer's pose at the start.
 *
 * @property room index into [Plan.rooms], or [Plan.NO_ROOM] to search the whole building
 * @property at in the room's frame; null when unknown
 * @property heading radians in the room's frame; null when unknown
 */
data class Start(val room: Int = Plan.NO_ROOM, val at: Point? = null, val heading: Double? = null)

/** Ordinals as in the core. */
enum class MotionKind {
    /** A step; the value is 1. */
    STEP,

    /** Turn rate about the vertical, rad/s, counter-clockwise. */
    YAW_RATE,

    /** Absolute heading in the level's frame, rad. */
    HEADING,
}

/** What the phone's own sensors say about the wearer's motion. */
data class MotionHint(val timeS: Double, val kind: MotionKind, val value: Double) {
    /** A step, or a turn faster than any gyroscope at rest drifts. */
    val isMovement get() = kind == MotionKind.STEP || kind == MotionKind.YAW_RATE && abs(value) > STILL_RAD_PER_S

    private companion object {
        const val STILL_RAD_PER_S = 0.15
    }
}

/**
 * One wearer in one building: the core, behind its handle. Not thread-safe: one thread gives it everything and
 * closes it. Times are seconds on one monotonic clock. Feeding it allocates nothing; reading [estimate] allocates
 * the value it returns.
 */
class CoreSession private constructor(handle: Long) : Closeable {
    private val handle = AtomicLong(handle)
    private val estimateBuffer = EstimateLayout.newBuffer()
    private val healthBuffer = BeltHealthLayout.newBuffer()
    private val bytes: ByteBuffer = ByteBuffer.allocateDirect(CHUNK_BYTES)
    private val cueBuffer = CueLayout.newBuffer()
    private val picture = GrowingBuffer(PICTURE_BYTES)

    /** The estimate after the newest input. */
    val estimate: Estimate get() = EstimateLayout.read(estimateBuffer)

    /** The belt's health now. */
    val beltHealth: BeltHealth
        get() {
            checked(NativeCore.beltHealth(open(), healthBuffer))
            return BeltHealthLayout.read(healthBuffer)
        }

    /** Bytes from the belt's line, cut anywhere. Returns how many firings they completed. */
    fun onBytes(data: ByteArray, arrivalS: Double): Int {
        var firings = 0
        for (from in data.indices step CHUNK_BYTES) {
            val length = minOf(CHUNK_BYTES, data.size - from)
            bytes.clear()
            bytes.put(data, from, length)
            firings += checked(NativeCore.onBytes(open(), bytes, length, arrivalS, estimateBuffer))
        }
        return firings
    }

    fun onMotion(hint: MotionHint) {
        checked(NativeCore.onMotion(open(), hint.kind.ordinal, hint.value, hint.timeS, estimateBuffer))
    }

    /** Time passes: at least twice a second while no bytes arrive, so that a silent belt is noticed. */
    fun onTick(nowS: Double) {
        checked(NativeCore.onTick(open(), nowS, estimateBuffer))
    }

    fun onBeltAttached(nowS: Double) {
        checked(NativeCore.onBelt(open(), true, nowS, estimateBuffer))
    }

    fun onBeltDetached(nowS: Double) {
        checked(NativeCore.onBelt(open(), false, nowS, estimateBuffer))
    }

    /** Forgets where the wearer is and has been, and starts over; a destination is kept, a way back ends. */
    fun restart(start: Start) {
        wish { error ->
            NativeCore.restart(
                open(), start.room, start.at?.x.orNaN, start.at?.y.orNaN, start.heading.orNaN, estimateBuffer, error,
            )
        }
    }

    /**
     * Leads the wearer to a place, an exit, a room or the nearest way out; cues answer.
     *
     * @throws CoreException when the building has no such thing or nothing leads there
     */
    fun setDestination(destination: Destination, preferences: RoutePreferences = RoutePreferences()) = wish { error ->
        NativeCore.setDestination(open(), destination.kind.ordinal, destination.index, preferences.avoidStairs, error)
    }

    /**
     * Leads the wearer back along their own breadcrumbs.
     *
     * @throws CoreException when there are none
     */
    fun backTrack() = wish { error -> NativeCore.backTrack(open(), error) }

    fun clearDestination() {
        checked(NativeCore.clearDestination(open()))
    }

    /** Cues answer with room, facing and nearest door once the next echo has come in. */
    fun whereAmI() {
        checked(NativeCore.whereAmI(open()))
    }

    /** Says the last instruction again; false, and no cue, when there is none that still holds. */
    fun repeat(): Boolean = checked(NativeCore.repeat(open())) != 0

    /** Takes the next cue that is to be spoken, in words of [style]; null when there is none. */
    fun nextCue(style: SpeechStyle = SpeechStyle()): Cue? {
        val size = checked(
            NativeCore.nextCue(
                open(), style.language.ordinal, style.direction.ordinal, style.length.ordinal, cueBuffer,
            ),
        )
        return if (size == 0) null else CueLayout.read(cueBuffer)
    }

    /** False once the wearer has arrived and stays. */
    val hasDestination: Boolean get() = checked(NativeCore.hasDestination(open())) != 0

    /** How far the nearest unmapped thing in the way is, metres from the chest; null when there is none. */
    val obstacleAheadM: Double? get() = NativeCore.obstacleAhead(open()).takeIf { it >= 0.0 }

    // What a picture of the session needs. Each allocates what it returns: for a few times a second, not
    // for every firing.

    /** The way to the destination from where the wearer is. */
    val route: Route get() = PictureLayout.route(picture.fill { checked(NativeCore.route(open(), it)) })

    /** Where the wearer has been, oldest first, thinned. */
    val breadcrumbs: List<Spot>
        get() = PictureLayout.spots(picture.fill { checked(NativeCore.breadcrumbs(open(), it)) })

    /** Places that explain the echoes, the most probable first. */
    val hypotheses: List<Hypothesis>
        get() = PictureLayout.hypotheses(picture.fill { checked(NativeCore.hypotheses(open(), it)) })

    /**
     * The newest reading of each sensor, by sensor, with what in the plan explains it. The first call
     * compiles the plan.
     */
    val scan: List<ExplainedEcho> get() = PictureLayout.echoes(picture.fill { checked(NativeCore.scan(open(), it)) })

    /**
     * Another session with another [belt] in the building as this one has loaded it: its files need not be there any
     * more. The air is as this session has heard of it ([BeltSetup.temperatureC] is not looked at), the seed the same.
     * Each is to be closed.
     *
     * @throws CoreException when there is no such belt or the start does not exist in the building
     */
    fun withBelt(belt: BeltSetup, nowS: Double, start: Start = Start()): CoreSession = opened(nowS) { error ->
        NativeCore.withBelt(
            open(),
            belt.sensors,
            belt.radiusM,
            belt.beamRad.orNaN,
            belt.slotS.orNaN,
            start.room,
            start.at?.x.orNaN,
            start.at?.y.orNaN,
            start.heading.orNaN,
            error,
        )
    }

    /** Safe to call twice. */
    override fun close() {
        val closing = handle.getAndSet(0L)
        if (closing != 0L) NativeCore.close(closing)
    }

    private fun wish(ask: (error: Array<String?>) -> Int) {
        val error = arrayOfNulls<String>(1)
        val status = ask(error)
        error[0]?.let { throw CoreException(it) }
        checked(status)
    }

    private fun open(): Long = handle.get().also { check(it != 0L) { "The session is closed." } }

    private fun checked(result: Int): Int {
        check(result >= 0) {
            when (result) {
                NativeCore.BAD_HANDLE -> "The core does not know this session."
                NativeCore.BAD_BUFFER -> "A buffer is too small or not direct."
                else -> "The core failed ($result)."
            }
        }
        return result
    }

    companion object {
        private const val CHUNK_BYTES = 4096
        private const val PICTURE_BYTES = 4096

        /** @throws CoreException when the building is unusable or the start does not exist in it */
        fun open(
            building: File,
            nowS: Double,
            start: Start = Start(),
            belt: BeltSetup = BeltSetup(),
            seed: Long = 1,
        ): CoreSession =
            opened(nowS) { error ->
                NativeCore.open(
                    building.path,
                    belt.sensors,
                    belt.radiusM,
                    belt.beamRad.orNaN,
                    belt.slotS.orNaN,
                    belt.temperatureC.orNaN,
                    start.room,
                    start.at?.x.orNaN,
                    start.at?.y.orNaN,
                    start.heading.orNaN,
                    seed,
                    error,
                )
            }

        private fun opened(nowS: Double, open: (error: Array<String?>) -> Long): CoreSession {
            val error = arrayOfNulls<String>(1)
            val handle = open(error)
            if (handle == 0L) throw CoreException(error[0] ?: "The building could not be opened.")
            val session = CoreSession(handle)
            session.onTick(nowS) // fills the estimate
            return session
        }
    }
}

/** How the core hears of what is not known. */
private val Double?.orNaN get() = this ?: Double.NaN
