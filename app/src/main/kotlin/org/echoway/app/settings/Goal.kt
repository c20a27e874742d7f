package org.echoway.app.settings

import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Plan
import org.echoway.core.destinations

/** Where the wearer is led, in the building of this id. */
data class Goal(val building: String, val destination: Destination) {
    /** The destination in a building; null where there is none such, or no longer. */
    fun within(id: String, plan: Plan): Destination? =
        destination.takeIf { id == building && (it == Destination.WAY_OUT || it in plan.destinations) }

    /** As a line of text: kind, index, building. */
    fun written() = "${destination.kind} ${destination.index} $building"

    companion object {
        /** Null for what another version wrote and this one cannot read. */
        fun read(line: String): Goal? {
            val parts = line.split(' ', limit = 3)
            val kind = DestinationKind.entries.firstOrNull { it.name == parts[0] }
            val index = parts.getOrNull(1)?.toIntOrNull()
            val building = parts.getOrNull(2)
            if (kind == null || index == null || building == null) return null
            return Goal(building, Destination(kind, index))
        }
    }
}
