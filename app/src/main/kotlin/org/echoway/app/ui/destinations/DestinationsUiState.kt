package org.echoway.app.ui.destinations

import org.echoway.core.Destination

/** Somewhere to go. [title] is all that a screen reader says of it. */
data class DestinationOption(val destination: Destination, val title: String, val chosen: Boolean)

/** Destinations of one kind; [title] is a heading. */
data class DestinationGroup(val title: String, val options: List<DestinationOption>)

/** What the screen of destinations shows. */
sealed interface DestinationsUiState {
    /** Nobody can be led while guidance is off. */
    data object Off : DestinationsUiState

    /**
     * @property leading where the wearer is led, in words
     * @property led whether they are
     * @property answered whether guidance says so itself, at once; a screen reader must not talk into that
     */
    data class Ready(
        val leading: String,
        val led: Boolean,
        val answered: Boolean,
        val groups: List<DestinationGroup>,
    ) : DestinationsUiState
}
