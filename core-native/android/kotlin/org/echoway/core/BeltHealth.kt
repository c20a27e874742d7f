package org.echoway.core

/** Ordinals as in the core. */
enum class BeltLink {
    /** Not attached, or attached and nothing heard yet. */
    ABSENT,

    /** Sentences arrive. */
    CONNECTED,

    /** Was connected; silent for too long, or detached. */
    LOST,
}

/** Ordinals as in the core. */
enum class SensorState {
    /** Not heard of yet. */
    UNKNOWN,
    GOOD,

    /** No echo for a whole window although others get some: covered or dead. */
    SILENT,

    /** The same reading whatever the wearer does. */
    STUCK,

    /** Steady false near readings. */
    INTERFERENCE,

    /** The belt itself reports a fault. */
    FAULT,
    ;

    /** Whether a wearer should know of it. */
    val isTrouble get() = this != UNKNOWN && this != GOOD
}

/**
 * What one sensor did lately.
 *
 * @property firings in the last minute; [echoes] of those had a range
 * @property lastRangeM from the transducer's face, metres; null when nothing answered
 * @property lastTimeS of its newest firing; negative before the first
 */
data class SensorHealth(
    val state: SensorState,
    val firings: Int,
    val echoes: Int,
    val faultCode: Int,
    val lastRangeM: Double?,
    val lastTimeS: Double,
)

/** How the belt is doing. Holds no position. */
data class BeltHealth(
    val link: BeltLink,
    val firingsPerSecond: Double,
    val goodSentences: Long,
    val badChecksums: Long,
    val malformed: Long,
    val lostFirings: Long,
    val restarts: Long,
    val temperatureC: Double?,
    val batteryV: Double?,
    val firmware: String,
    val sensors: List<SensorHealth>,
) {
    companion object {
        val NONE = BeltHealth(BeltLink.ABSENT, 0.0, 0, 0, 0, 0, 0, null, null, "", emptyList())
    }
}
