package org.echoway.app.touch

/** The vocabulary of touch. One motor, so patterns, not sides. */
enum class Touch {
    LEFT,
    RIGHT,
    AHEAD,
    TURN_AROUND,
    ARRIVED,
    ROOM_ENTERED,
    UNSURE,
    BELT_LOST,
    BELT_BACK,
}

/** Something that vibrates, or a phone that cannot. */
interface Buzzer {
    val present: Boolean

    fun play(touch: Touch)
}

/**
 * Pauses and pulses in milliseconds, beginning with a pause; a strength (1 ... 255) for each, 0 for pauses. Gaps are 50 ms
 * or more and strengths at least a ratio of 1.4 apart, so that they can be told apart through a jacket.
 */
data class TouchPattern(val timingsMs: List<Long>, val strengths: List<Int>)

val Touch.pattern: TouchPattern
    get() = when (this) {
        Touch.LEFT -> pulses(LONG_MS to STRONG, SHORT_MS to STRONG)
        Touch.RIGHT -> pulses(SHORT_MS to STRONG, LONG_MS to STRONG)
        Touch.AHEAD -> pulses(SHORT_MS to STRONG)
        Touch.TURN_AROUND -> pulses(LONG_MS to STRONG, LONG_MS to STRONG)
        Touch.ARRIVED -> pulses(SHORT_MS to SOFT, SHORT_MS to MEDIUM, SHORT_MS to STRONG)
        Touch.ROOM_ENTERED -> pulses(SHORT_MS to MEDIUM, SHORT_MS to MEDIUM)
        Touch.UNSURE -> pulses(VERY_LONG_MS to SOFT)
        Touch.BELT_LOST -> pulses(LONG_MS to STRONG, LONG_MS to STRONG, LONG_MS to STRONG)
        Touch.BELT_BACK -> pulses(SHORT_MS to STRONG, SHORT_MS to STRONG, SHORT_MS to STRONG)
    }

private fun pulses(vararg pulses: Pair<Long, Int>) = TouchPattern(
    timingsMs = pulses.flatMapIndexed { index, (length, _) -> listOf(if (index == 0) 0L else GAP_MS, length) },
    strengths = pulses.flatMap { (_, strength) -> listOf(0, strength) },
)

private const val SHORT_MS = 90L
private const val LONG_MS = 350L
private const val VERY_LONG_MS = 1200L
private const val GAP_MS = 120L
private const val STRONG = 255
private const val MEDIUM = 170
private const val SOFT = 110
