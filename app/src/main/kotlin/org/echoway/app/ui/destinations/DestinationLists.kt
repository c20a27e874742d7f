package org.echoway.app.ui.destinations

import android.content.res.Resources
import org.echoway.app.R
import org.echoway.app.guide.Wording
import org.echoway.core.Destination
import org.echoway.core.DestinationKind
import org.echoway.core.Plan
import org.echoway.core.destinations

/** What a plan has by name, in lists that a wearer chooses from. */
class DestinationLists(private val resources: Resources) {
    private val wording = Wording(resources)

    /** A list for each of [kinds] that there is any of. */
    fun groups(plan: Plan, kinds: List<DestinationKind>, chosen: Destination? = null): List<DestinationGroup> =
        kinds.map { group(plan, it, resources.getString(TITLES.getValue(it)), chosen) }
            .filter { it.options.isNotEmpty() }

    private fun group(plan: Plan, kind: DestinationKind, title: String, chosen: Destination?): DestinationGroup {
        val levels = plan.rooms.map { it.level }.distinct().size > 1
        val options = plan.destinations.filter { it.kind == kind && plan.isNamed(it) }
            .map { DestinationOption(it, title(plan, it, levels), it == chosen) }
        return DestinationGroup(title, options.sortedWith(compareBy(NATURAL) { it.title }))
    }

    /** Enough to tell it from its namesakes, and nothing that is the same for all. */
    private fun title(plan: Plan, destination: Destination, levels: Boolean): String {
        val name = wording.name(plan, destination)
        val room = plan.rooms[plan.roomOf(destination)]
        return when {
            destination.kind != DestinationKind.ROOM ->
                resources.getString(R.string.place_in_room, name, wording.name(room))
            levels -> resources.getString(R.string.room_on_level, name, room.level)
            else -> name
        }
    }

    private fun Plan.isNamed(destination: Destination) =
        destination.kind != DestinationKind.PLACE || places[destination.index].name.isNotEmpty()

    private fun Plan.roomOf(destination: Destination) = when (destination.kind) {
        DestinationKind.PLACE -> places[destination.index].spot.room
        DestinationKind.EXIT -> exits[destination.index].spot.room
        else -> destination.index
    }

    private companion object {
        val TITLES = mapOf(
            DestinationKind.PLACE to R.string.places,
            DestinationKind.EXIT to R.string.exits,
            DestinationKind.ROOM to R.string.rooms,
        )
        const val WIDTH = 8

        /** Room 10 after room 9. */
        val NATURAL = Comparator<String> { a, b -> padded(a).compareTo(padded(b), ignoreCase = true) }

        private fun padded(text: String) = text.replace(Regex("\\d+")) { it.value.padStart(WIDTH, '0') }
    }
}
