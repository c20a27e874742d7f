package org.echoway.app.guide

import org.echoway.core.Room

/** How much a line matters; earlier ranks are spoken first. */
enum class Rank {
    DANGER,
    LOST_OR_BROKEN,
    TURN,
    ASKED,
    PLACE,
    COLOUR,
    ;

    /** Whether a line of this rank may cut off one of [other]. */
    fun cutsOff(other: Rank) = this < other && this <= LOST_OR_BROKEN
}

/** Something with a direction and a distance, metres; [sigmaM] is how well the distance is known. */
data class Seen(val direction: Direction, val distanceM: Double, val sigmaM: Double)

/**
 * Something that the wearer is told.
 *
 * @property topic what it is about: a newer message takes the place of one that waits on the same topic
 * @property validS how long it may wait before it is stale
 */
sealed class Message(val rank: Rank, val topic: String, val validS: Double) {
    data class RoomEntered(val room: Room) : Message(Rank.PLACE, "room", ROUTINE_S)

    data class DoorNear(val seen: Seen) : Message(Rank.PLACE, "door", BRIEF_S)

    data class PlaceNear(val name: String, val seen: Seen) : Message(Rank.PLACE, "place", BRIEF_S)

    data object Unsure : Message(Rank.LOST_OR_BROKEN, "position", LASTING_S)

    data class FoundAgain(val room: Room, val door: Direction?) : Message(Rank.LOST_OR_BROKEN, "position", ROUTINE_S)

    data object Searching : Message(Rank.PLACE, "position", ROUTINE_S)

    data object BeltLost : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    data object BeltBack : Message(Rank.LOST_OR_BROKEN, "belt", ROUTINE_S)

    data object BeltNotAllowed : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    data object RecordingOver : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    data class SensorBlocked(val side: Side, val sensor: Int) : Message(Rank.LOST_OR_BROKEN, "sensor $sensor", LASTING_S)

    data class SensorClear(val side: Side, val sensor: Int) : Message(Rank.LOST_OR_BROKEN, "sensor $sensor", ROUTINE_S)

    data class SensorsBlocked(val count: Int) : Message(Rank.LOST_OR_BROKEN, "sensors", LASTING_S)

    data object BatteryLow : Message(Rank.LOST_OR_BROKEN, "battery", LASTING_S)

    data class CannotStart(val reason: String) : Message(Rank.LOST_OR_BROKEN, "start", LASTING_S)

    data object NoVibration : Message(Rank.COLOUR, "vibration", LASTING_S)

    /** The answer to "Where am I?". */
    data class WhereAmI(val answer: Answer) : Message(Rank.ASKED, "answer", ROUTINE_S)

    private companion object {
        const val BRIEF_S = 3.0
        const val ROUTINE_S = 6.0

        /** True until another message of the topic says otherwise. */
        const val LASTING_S = 120.0
    }
}

/** What is known when the wearer asks. */
sealed interface Answer {
    /** @property facing null when nothing was found straight ahead */
    data class Here(val room: Room, val facing: Facing?, val door: Seen?, val place: NamedSeen?) : Answer

    /** @property likely the most probable room, when one stands out */
    data class Unsure(val likely: Room?) : Answer

    data class NoBelt(val lastRoom: Room?) : Answer

    data object NotRunning : Answer
}

data class NamedSeen(val name: String, val seen: Seen)

/** What is straight ahead. */
sealed interface Facing {
    data object Door : Facing

    data class Place(val name: String) : Facing

    data class Wall(val distanceM: Double, val sigmaM: Double) : Facing
}
