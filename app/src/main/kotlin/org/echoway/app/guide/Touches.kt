package org.echoway.app.guide

import kotlin.math.abs
import org.echoway.app.touch.Touch
import org.echoway.core.Cue
import org.echoway.core.CueKind

/** What is felt along with the words, or instead of them. */
internal val Message.touch: Touch?
    get() = when (this) {
        is Message.Told -> cue.touch
        Message.BeltLost -> Touch.BELT_LOST
        is Message.BeltChanged -> Touch.UNSURE
        Message.BeltBack -> Touch.BELT_BACK
        Message.StillSoon, Message.StillAlarm -> Touch.MOVE_NOW
        else -> null
    }

/** What tells a line from others on a phone that cannot speak: what is felt, and for danger always something. */
internal val Message.sign: Touch? get() = touch ?: Touch.SOMETHING_AHEAD.takeIf { rank == Rank.DANGER }

private val Cue.touch: Touch?
    get() = when (kind) {
        CueKind.TURN, CueKind.PROBE_TURN -> towards(direction)
        CueKind.GO_STRAIGHT -> Touch.AHEAD
        CueKind.ARRIVED -> Touch.ARRIVED
        CueKind.UNCERTAIN -> Touch.UNSURE
        CueKind.ENTERING -> Touch.ROOM_ENTERED
        CueKind.FOUND, CueKind.WRONG_WAY, CueKind.REROUTED -> way
        // The ticks go on for as long as the thing is in the way.
        CueKind.OBSTACLE -> null
        CueKind.STOP -> way ?: Touch.SOMETHING_AHEAD
        else -> null
    }

/** What the second half of a line asks for. */
private val Cue.way: Touch?
    get() = when (tail?.kind) {
        CueKind.TURN -> towards(tail?.direction)
        CueKind.GO_STRAIGHT -> Touch.AHEAD
        else -> Touch.ROOM_ENTERED.takeIf { kind == CueKind.FOUND }
    }

private fun towards(direction: Double?): Touch? = when {
    direction == null -> null
    abs(direction) <= AHEAD_RAD -> Touch.AHEAD
    abs(direction) > BEHIND_RAD -> Touch.TURN_AROUND
    direction > 0 -> Touch.LEFT
    else -> Touch.RIGHT
}

// The sectors of docs/guidance.md.
private val AHEAD_RAD = Math.toRadians(20.0)
private val BEHIND_RAD = Math.toRadians(160.0)
