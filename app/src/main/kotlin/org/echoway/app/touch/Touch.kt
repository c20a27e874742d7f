package org.echoway.app.touch

/** The vocabulary of touch. One motor, so patterns, not sides. */
enum class Touch {
    LEFT,
    RIGHT,
    AHEAD,
    TURN_AROUND,
    ARRIVED,

    /** One tick of several, which quicken as the thing comes nearer: see [tickGapMs]. */
    SOMETHING_AHEAD,
    ROOM_ENTERED,
    UNSURE,
    BELT_LOST,
    BELT_BACK,

    /** Firefighter mode: not moved for a while. */
    MOVE_NOW,
}

/** Something that vibrates, or a phone that cannot. */
interface Buzzer {
    val present: Boolean

    fun play(touch: Touch)
}

/** Lengths that can be told apart through a jacket. */
enum class Length(val ms: Long) { TICK(40), SHORT(90), LONG(350), VERY_LONG(1200) }

/** Strengths, 1 ... 255, at least a ratio of 1.4 apart. */
enum class Strength(val amplitude: Int) { SOFT(110), MEDIUM(170), STRONG(255) }

data class Pulse(val length: Length, val strength: Strength) {
    /** Where strength cannot be felt, length stands for it. */
    val lengthAtOneStrengthMs: Long
        get() = when (strength) {
            Strength.SOFT -> length.ms / 2
            Strength.MEDIUM -> length.ms * 7 / 10
            Strength.STRONG -> length.ms
        }
}

/** Between two pulses, milliseconds: more than the 50 that it takes to feel two. */
const val GAP_MS = 120L

val Touch.pulses: List<Pulse>
    get() = when (this) {
        Touch.LEFT -> listOf(LONG, SHORT)
        Touch.RIGHT -> listOf(SHORT, LONG)
        Touch.AHEAD -> listOf(SHORT)
        Touch.TURN_AROUND -> listOf(LONG, LONG)
        Touch.ARRIVED -> Strength.entries.map { Pulse(Length.SHORT, it) }
        Touch.SOMETHING_AHEAD -> listOf(Pulse(Length.TICK, Strength.STRONG))
        Touch.ROOM_ENTERED -> listOf(Pulse(Length.SHORT, Strength.MEDIUM), Pulse(Length.SHORT, Strength.MEDIUM))
        Touch.UNSURE -> listOf(Pulse(Length.VERY_LONG, Strength.SOFT))
        Touch.BELT_LOST -> listOf(LONG, LONG, LONG)
        Touch.BELT_BACK -> listOf(SHORT, SHORT, SHORT)
        Touch.MOVE_NOW -> listOf(Pulse(Length.VERY_LONG, Strength.STRONG))
    }

/** How long a word takes to be felt, milliseconds. */
val Touch.durationMs: Long get() = pulses.sumOf { it.length.ms } + GAP_MS * (pulses.size - 1)

/** From one tick to the next, milliseconds: twelve a second at arm's length, two a second at two and a half metres. */
fun tickGapMs(distanceM: Double): Long = (distanceM * TICK_MS_PER_M).toLong().coerceIn(FASTEST_TICK_MS, SLOWEST_TICK_MS)

private val LONG = Pulse(Length.LONG, Strength.STRONG)
private val SHORT = Pulse(Length.SHORT, Strength.STRONG)
private const val TICK_MS_PER_M = 200.0

/** A tick and the 50 ms that let one feel the next. */
private const val FASTEST_TICK_MS = 90L
private const val SLOWEST_TICK_MS = 600L
