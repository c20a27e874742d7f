package org.echoway.app.ui.setup

import org.echoway.app.settings.SourceKind

/** One of several things to choose from; [id] is null, and [title] empty, for "I do not know". */
data class Option(val id: String?, val title: String, val chosen: Boolean)

/** A belt source to choose from. [available] is false where it has nothing to play. */
data class SourceOption(val kind: SourceKind, val chosen: Boolean, val available: Boolean)

/** What the setup screen shows. */
sealed interface SetupUiState {
    data object Loading : SetupUiState

    /** No usable floor plan is on this phone. */
    data object NoBuildings : SetupUiState

    /**
     * @property entrances of the chosen building, the first being "I do not know"; empty while none is chosen
     * @property recordingProblem why the picked recording cannot be played; null when there is nothing to say
     */
    data class Ready(
        val buildings: List<Option>,
        val entrances: List<Option>,
        val sources: List<SourceOption>,
        val recordingProblem: String?,
    ) : SetupUiState {
        val complete get() = buildings.any { it.chosen } && sources.any { it.chosen && it.available }
    }
}
