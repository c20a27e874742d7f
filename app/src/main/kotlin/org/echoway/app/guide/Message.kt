package org.echoway.app.guide

import org.echoway.app.engine.NoStart
import org.echoway.core.Cue
import org.echoway.core.CueKind
import org.echoway.core.Destination
import org.echoway.core.Plan
import org.echoway.core.Room
import org.echoway.core.Urgency

/** How much a line matters; earlier ranks are spoken first. In the order of the core's [Urgency]. */
enum class Rank {
    DANGER,
    LOST_OR_BROKEN,
    TURN,
    ASKED,
    PLACE,
    COLOUR,
    ;

    /**
     * Whether a line of this rank may cut off one of [other]: what is only nice to know waits for the end of a line.
     */
    fun cutsOff(other: Rank) = this < other && this <= TURN

    companion object {
        fun of(urgency: Urgency) = entries[urgency.ordinal]
    }
}

/**
 * Something that the wearer is told.
 *
 * @property topic what it is about: a newer message takes the place of one that waits on the same topic
 * @property validS how long it may wait before it is stale
 */
sealed class Message(val rank: Rank, val topic: String, val validS: Double) {
    /** What the core says of position and way; it brings its own words. */
    data class Told(val cue: Cue) : Message(Rank.of(cue.urgency), cue.topic, cue.validS)

    data object BeltLost : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    /** Guidance began and nothing is on the line. */
    data object WaitingForBelt : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    data object BeltBack : Message(Rank.LOST_OR_BROKEN, "belt", ROUTINE_S)

    data object BeltNotAllowed : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    /** The wearer did not allow the belt's use, perhaps by mistake. */
    data object BeltRefused : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    /** The belt has another number of sensors than was thought; the place is lost. */
    data class BeltChanged(val sensors: Int) : Message(Rank.LOST_OR_BROKEN, "other belt", LASTING_S)

    /** What will be said is not of where the wearer is. */
    data object RecordedWalk : Message(Rank.LOST_OR_BROKEN, "recorded walk", LASTING_S)

    /** Android had ended the app, and brings guidance back; to [goal] of [plan], null when the way is forgotten. */
    data class Interrupted(val plan: Plan, val goal: Destination?) : Message(Rank.LOST_OR_BROKEN, "start", LASTING_S)

    data object RecordingOver : Message(Rank.LOST_OR_BROKEN, "belt", LASTING_S)

    data class SensorBlocked(
        val side: Side,
        val sensor: Int,
    ) : Message(Rank.LOST_OR_BROKEN, "sensor $sensor", LASTING_S)

    data class SensorClear(val side: Side, val sensor: Int) : Message(Rank.LOST_OR_BROKEN, "sensor $sensor", ROUTINE_S)

    data class SensorsBlocked(val count: Int) : Message(Rank.LOST_OR_BROKEN, "sensors", LASTING_S)

    /** The walk is no longer written down. */
    data class RecordingStopped(val diskFull: Boolean) : Message(Rank.LOST_OR_BROKEN, "recording", LASTING_S)

    data object BatteryLow : Message(Rank.LOST_OR_BROKEN, "battery", LASTING_S)

    data class CannotStart(val why: NoStart) : Message(Rank.LOST_OR_BROKEN, "start", LASTING_S)

    /** The wearer, or a hand in a pocket, ended guidance. */
    data object Stopped : Message(Rank.LOST_OR_BROKEN, "start", ROUTINE_S)

    data object NoVibration : Message(Rank.LOST_OR_BROKEN, "vibration", LASTING_S)

    /** What is nice to know of a room that was entered. */
    data class RoomDetail(val doors: Int, val places: List<String>) : Message(Rank.COLOUR, "room detail", ROUTINE_S)

    /** The answer to "Where am I?" when the core cannot give it. */
    data class Unanswerable(val why: NoAnswer) : Message(Rank.ASKED, "answer", ROUTINE_S)

    /** What was said last, again. */
    data class Again(val words: String) : Message(Rank.ASKED, "again", ROUTINE_S)

    data object NothingToRepeat : Message(Rank.ASKED, "again", ROUTINE_S)

    data class Muted(val on: Boolean) : Message(Rank.ASKED, "mute", ROUTINE_S)

    data class CannotLead(val why: NoWay) : Message(Rank.ASKED, "leading", ROUTINE_S)

    data object LeadingBack : Message(Rank.ASKED, "leading", ROUTINE_S)

    data object LeadingStopped : Message(Rank.ASKED, "leading", ROUTINE_S)

    /** Where the wearer came from is no longer known. */
    data object WayBackLost : Message(Rank.LOST_OR_BROKEN, "way back", LASTING_S)

    /**
     * The wearer is looked for anew; [place] of [plan] is where they say that they stand, null when they do not know.
     */
    data class StartedAgain(val plan: Plan, val place: Destination?) : Message(Rank.ASKED, "start again", ROUTINE_S)

    /** Nobody can stand where they say that they do. */
    data class CannotStandAt(val plan: Plan, val place: Destination?) : Message(Rank.ASKED, "start again", ROUTINE_S)

    /** What firefighter mode is not. */
    data object NotAPass : Message(Rank.ASKED, "firefighter", LASTING_S)

    /** Nobody watches any more: whoever relied on it must know. */
    data object WatchEnded : Message(Rank.LOST_OR_BROKEN, "firefighter", LASTING_S)

    data object StillSoon : Message(Rank.DANGER, "still", ANSWER_S)

    data object StillAlarm : Message(Rank.DANGER, "still", LASTING_S)

    data object StillCancelled : Message(Rank.ASKED, "still", ROUTINE_S)

    /** A line of the practice screen or of the first run. */
    data class Explanation(val words: String) : Message(Rank.ASKED, EXPLANATION, LASTING_S)

    companion object {
        const val EXPLANATION = "explanation"
        const val ROUTINE_S = 6.0

        /** True until another message of the topic says otherwise. */
        const val LASTING_S = 120.0

        /** Answers of several lines: the voice may be slower than the core thinks. */
        const val ANSWER_S = 12.0
    }
}

/** Why "Where am I?" has no answer. */
sealed interface NoAnswer {
    data class NoBelt(val lastRoom: Room?) : NoAnswer

    /** A belt is plugged in that the wearer has not allowed to be used; they are asked once more. */
    data object NotAllowed : NoAnswer

    data object NotRunning : NoAnswer
}

/** Why nobody is led. */
enum class NoWay { NO_EXIT_KNOWN, NOTHING_WALKED_YET, NOT_REACHABLE, NOT_RUNNING }

/** Lines that take each other's place while they wait. */
private val Cue.topic: String
    get() = when (kind) {
        CueKind.STOP, CueKind.OBSTACLE -> "danger"
        CueKind.UNCERTAIN, CueKind.PROBE_TURN, CueKind.PROBE_STEP, CueKind.FOUND -> "position"
        CueKind.WRONG_WAY, CueKind.REROUTED, CueKind.NO_WAY, CueKind.TURN, CueKind.BEAR, CueKind.GO_STRAIGHT,
        CueKind.ARRIVED, CueKind.TAKE_LINK,
        -> "way"
        CueKind.ROOM_HERE, CueKind.FACING, CueKind.DESTINATION -> "answer $kind"
        else -> if (urgency == Urgency.ASKED) "answer $kind" else kind.name
    }

/**
 * A loss holds until it is taken back; an answer is waited for; a room is not left at once; the rest is true only here.
 */
private val Cue.validS: Double
    get() = when {
        urgency == Urgency.BROKEN -> Message.LASTING_S
        urgency == Urgency.ASKED -> Message.ANSWER_S
        kind == CueKind.ENTERING -> Message.ROUTINE_S
        else -> timeToLiveS
    }
