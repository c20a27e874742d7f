package org.echoway.app.engine

import org.echoway.core.Cue
import org.echoway.core.Destination
import org.echoway.core.ExplainedEcho
import org.echoway.core.Hypothesis
import org.echoway.core.Route
import org.echoway.core.RoutePreferences
import org.echoway.core.SpeechStyle
import org.echoway.core.Spot
import org.echoway.core.Start

/** What a wearer asks of guidance. The core answers with cues. */
sealed interface Wish {
    data object WhereAmI : Wish

    /** The last instruction again. */
    data object Repeat : Wish

    data class LeadTo(val destination: Destination, val preferences: RoutePreferences = RoutePreferences()) : Wish

    /** Back the way one came. */
    data object BackTrack : Wish

    data object StopLeading : Wish

    /**
     * The wearer says where they stand, [place] if they can name it: all that was thought of it before is forgotten.
     */
    data class StandAt(val start: Start, val place: Destination? = null) : Wish

    /** To be asked once more whether the belt may be used. */
    data object AllowBelt : Wish
}

/** What a guide has of the core. Safe from any thread. */
interface Core {
    /** Forgotten when navigation does not run. */
    fun ask(wish: Wish)

    /** How cues are put into words from now on. */
    fun speakIn(style: SpeechStyle)
}

/** What guidance has to say, in order. */
sealed interface GuidanceEvent {
    data class Told(val cue: Cue) : GuidanceEvent

    /** [wish] is met from now on, or about to be answered by cues. */
    data class Granted(val wish: Wish) : GuidanceEvent

    /** [wish] cannot be met; [reason] is the core's own sentence, for a log. */
    data class Refused(val wish: Wish, val reason: String) : GuidanceEvent

    /** The belt turned out to have [sensors]; what was heard before is void, and the wearer is looked for anew. */
    data class BeltChanged(val sensors: Int) : GuidanceEvent

    /** The wearer was on their way back, and where they came from is no longer known. */
    data object WayBackLost : GuidanceEvent
}

/** What a picture of navigation shows besides the estimate. */
data class Picture(
    val route: Route = Route.NONE,
    val breadcrumbs: List<Spot> = emptyList(),
    val hypotheses: List<Hypothesis> = emptyList(),
    val scan: List<ExplainedEcho> = emptyList(),
)
