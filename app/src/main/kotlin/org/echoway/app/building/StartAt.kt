package org.echoway.app.building

import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Plan
import org.echoway.core.Start

/** Where a wearer starts who stands at an exit or in a room of the plan; anywhere for everything else. */
fun startAt(plan: Plan, place: Destination?): Start = when (place?.kind) {
    // The room alone: nobody stands on the very point, and a start that is too sure of itself is hard to unlearn.
    DestinationKind.EXIT -> Start(room = plan.exits[place.index].spot.room)
    DestinationKind.ROOM -> Start(room = place.index)
    else -> Start()
}

/** Where a wearer starts who came in by the entrance of this name; anywhere when it is null or unknown. */
fun startAt(plan: Plan, entrance: String?): Start = startAt(plan, plan.entrance(entrance))

/** The entrance of this name; null when it is unknown. */
fun Plan.entrance(name: String?): Destination? =
    exits.indexOfFirst { it.name == name }.takeIf { it >= 0 }?.let { Destination(DestinationKind.EXIT, it) }
