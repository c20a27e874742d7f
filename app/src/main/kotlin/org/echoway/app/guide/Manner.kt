package org.echoway.app.guide

import org.echoway.app.settings.ServiceModel
import org.echoway.app.settings.Verbosity
import org.echoway.core.CueKind

/**
 * Whether a message is spoken at all. Danger, losses, broken things and answers always are: silence must go on meaning
 * that all is well.
 */
data class Manner(
    val service: ServiceModel = ServiceModel.CONTINUOUS,
    val verbosity: Verbosity = Verbosity.NORMAL,
    val muted: Boolean = false,
) {
    fun speaks(message: Message): Boolean = when {
        message.rank <= Rank.LOST_OR_BROKEN || message.rank == Rank.ASKED || message.cue in LOSSES -> true
        muted -> false
        service == ServiceModel.ON_REQUEST -> message.cue in RESULTS
        verbosity == Verbosity.FULL || message.rank == Rank.TURN -> true
        message.rank == Rank.COLOUR -> false
        else -> verbosity == Verbosity.NORMAL || message.cue in WITH_CARE
    }

    private val Message.cue: CueKind? get() = (this as? Message.Told)?.cue?.kind

    private companion object {
        /** All was well and is no more. */
        val LOSSES = setOf<CueKind?>(CueKind.WRONG_WAY, CueKind.NO_WAY)

        /** What a wearer who asked to be led waits for. */
        val RESULTS = setOf<CueKind?>(CueKind.ARRIVED)

        /** Places that one does not walk into unwarned. */
        val WITH_CARE = setOf<CueKind?>(CueKind.STAIRS, CueKind.ELEVATOR, CueKind.NARROW)
    }
}
