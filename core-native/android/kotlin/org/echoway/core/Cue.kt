package org.echoway.core

/** What a wearer is told; ordinals as in the core. */
enum class CueKind {
    /** Stand still: the next step may meet a wall. */
    STOP,

    /** Something that no plan knows is near. */
    OBSTACLE,

    /** Not sure where the wearer is: stop and turn slowly. */
    UNCERTAIN,
    PROBE_TURN,
    PROBE_STEP,

    /** Sure again. */
    FOUND,
    BELT_LOST,
    BELT_BACK,
    BATTERY_LOW,
    SENSOR_BLOCKED,
    WRONG_WAY,
    REROUTED,
    NO_WAY,
    TURN,
    BEAR,
    GO_STRAIGHT,
    ARRIVED,
    TAKE_LINK,
    ROOM_HERE,
    FACING,
    DESTINATION,
    DOOR,
    STAIRS,
    ELEVATOR,
    EXIT,
    PLACE,
    NARROW,
    ENTERING,
}

/** Which line goes first; ordinals as in the core. */
enum class Urgency {
    DANGER,

    /** Lost, or something does not work. */
    BROKEN,
    TURN,
    ASKED,
    PLACE,
    COLOUR,
}

/** What a cue speaks of; ordinals as in the core. */
enum class LandmarkKind { NONE, DOOR, LINK, PLACE, EXIT, ROOM }

/** @property index into the [Plan]'s doors, links, places, exits or rooms */
data class CueLandmark(val kind: LandmarkKind, val index: Int)

/** A second fact in the same breath. */
data class CueTail(val kind: CueKind, val direction: Double, val distanceM: Double?)

/**
 * Something that the core wants the wearer to know, and the words for it.
 *
 * @property timeS when it should begin to be spoken
 * @property direction from the chest, radians in (-pi, pi], left is positive; null when it has none
 * @property distanceM null when it is not said; [sigmaM] is how well it is known
 * @property timeToLiveS too late to be spoken after that
 * @property up stairs and elevators: upwards
 * @property count steps of a flight; 0 when not known
 * @property room index into [Plan.rooms], or [Plan.NO_ROOM]
 * @property words in the language and units that were asked for
 */
data class Cue(
    val timeS: Double,
    val kind: CueKind,
    val urgency: Urgency,
    val direction: Double?,
    val distanceM: Double?,
    val sigmaM: Double,
    val timeToLiveS: Double,
    val up: Boolean,
    val count: Int,
    val room: Int,
    val landmark: CueLandmark,
    val tail: CueTail?,
    val words: String,
)

/** Languages that the core has words in; ordinals as in the core. */
enum class Language(val tag: String) {
    ENGLISH("en"),
    GERMAN("de"),
    FRENCH("fr"),
    ;

    companion object {
        /** The language of a BCP 47 tag, or English when there are no words in it. */
        fun of(tag: String) =
            entries.firstOrNull { it.tag == tag.lowercase().substringBefore('-').substringBefore('_') } ?: ENGLISH
    }
}

/** How directions are given; ordinals as in the core. */
enum class DirectionStyle {
    /** "slightly left", "behind you". */
    SIDES,

    /** "at two o'clock". */
    CLOCK,

    /** "left, forty degrees". */
    DEGREES,
}

/** How lengths are given; ordinals as in the core. */
enum class LengthStyle { FEET, METRES, STEPS }

/** How cues are put into words. */
data class SpeechStyle(
    val language: Language = Language.ENGLISH,
    val direction: DirectionStyle = DirectionStyle.SIDES,
    val length: LengthStyle = LengthStyle.FEET,
)
