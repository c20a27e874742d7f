package org.echoway.app.engine

import org.echoway.app.building.InstalledBuilding
import org.echoway.core.BeltHealth
import org.echoway.core.Destination
import org.echoway.core.Estimate
import org.echoway.core.Plan

/** What navigation knows now; screen, voice, touch and notification all observe this and nothing else. */
sealed interface NavigationState {
    /** What the wearer walks through; null while guidance is off. */
    val plan: Plan? get() = null

    data object Idle : NavigationState

    /** Navigation could not begin; [reason] says more, in the core's own words. */
    data class Failed(val why: NoStart, val reason: String) : NavigationState

    /**
     * @property timeS when this was so, on the app's clock
     * @property line how the belt's line is, as its source says
     * @property belt what the core heard on it
     * @property leading what the wearer is led to ([Wish.LeadTo] or [Wish.BackTrack]); null without a destination
     * @property obstacleM how far the nearest unmapped thing in the way is, metres; null when there is none
     * @property movedS when the wearer last moved for sure, on the app's clock
     * @property live whether a belt is worn now; false while a recorded walk is played
     */
    data class Running(
        val building: InstalledBuilding,
        val timeS: Double,
        val line: Line,
        val belt: BeltHealth,
        val estimate: Estimate,
        val leading: Wish? = null,
        val obstacleM: Double? = null,
        val movedS: Double = timeS,
        val live: Boolean = true,
    ) : NavigationState {
        override val plan: Plan get() = building.plan

        /** Where the wearer is led; null nowhere, or back the way they came. */
        val destination: Destination? get() = (leading as? Wish.LeadTo)?.destination
    }
}

/** The belt's line, before anything on it is understood. */
enum class Line {
    WAITING,

    /** The phone asks the wearer for leave to use the belt. */
    PERMISSION_MISSING,

    /** They did not give it. */
    REFUSED,
    OPEN,
    GONE,
    ENDED,
    ;

    /** A belt is plugged in that may not be used. */
    val isForbidden get() = this == PERMISSION_MISSING || this == REFUSED
}

/** Why guidance cannot begin. */
enum class NoStart { NO_BUILDING, BUILDING_UNUSABLE, RECORDING_UNREADABLE }
