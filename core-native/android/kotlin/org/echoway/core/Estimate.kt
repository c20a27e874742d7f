package org.echoway.core

/** Whether one place explains the echoes; ordinals as in the core. */
enum class TrackState {
    /** Several places still explain the echoes. */
    SEARCHING,

    /** One place does, and it keeps doing so. */
    TRACKING,

    /** The echoes fit nowhere that the wearer could be. */
    LOST,
}

/**
 * Where the wearer is, as well as it is known.
 *
 * @property timeS seconds on the session's clock
 * @property room index into [Plan.rooms], or [Plan.NO_ROOM]
 * @property x metres in the room's frame, as [y]
 * @property heading radians counter-clockwise from the room's +x
 * @property sigmaM standard deviation of the position along its worst direction, metres
 * @property covarianceXx square metres in the room's frame, as [covarianceXy] and [covarianceYy]
 * @property speedMps along the heading
 * @property soundSpeedScale true speed of sound over the assumed one
 */
data class Estimate(
    val timeS: Double,
    val room: Int,
    val x: Double,
    val y: Double,
    val heading: Double,
    val sigmaM: Double,
    val sigmaHeading: Double,
    val roomProbability: Double,
    val state: TrackState,
    val covarianceXx: Double,
    val covarianceXy: Double,
    val covarianceYy: Double,
    val speedMps: Double,
    val soundSpeedScale: Double,
)
