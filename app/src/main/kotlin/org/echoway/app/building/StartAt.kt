package org.echoway.app.building

import org.echoway.core.Plan
import org.echoway.core.Start

/** Where a wearer starts who came in by the entrance of this name; anywhere when it is null or unknown. */
fun startAt(plan: Plan, entrance: String?): Start {
    val exit = plan.exits.firstOrNull { it.name == entrance } ?: return Start()
    // The room alone: nobody stands on the very point, and a start that is too sure of itself is hard to unlearn.
    return Start(room = exit.spot.room)
}
