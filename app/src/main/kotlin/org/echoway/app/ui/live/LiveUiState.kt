package org.echoway.app.ui.live

import org.echoway.app.engine.Picture
import org.echoway.core.Estimate
import org.echoway.core.LengthStyle
import org.echoway.core.Plan

/** What the live screen shows. */
sealed interface LiveUiState {
    /** Settings are being read. */
    data object Loading : LiveUiState

    /** No building was chosen yet. */
    data object NeedsSetup : LiveUiState

    /** Guidance is off; the map of the chosen building can be looked at. */
    data class Off(
        val building: String,
        val plan: Plan,
        val voiceMissing: Boolean = false,
        val lengths: LengthStyle = LengthStyle.FEET,
    ) : LiveUiState

    /** Guidance could not begin: [words] say why, [reason] more of it in the core's own words. */
    data class Failed(val words: String, val reason: String) : LiveUiState

    /**
     * Guidance is on.
     *
     * @property words the state in words
     * @property lastLine what was said last
     * @property wearer where the wearer is drawn; null while no room is known
     * @property picture trail and way
     * @property lengths the wearer's unit
     * @property voiceMissing the phone cannot speak
     */
    data class On(
        val building: String,
        val plan: Plan,
        val words: String,
        val lastLine: String,
        val wearer: Estimate?,
        val level: Int,
        val voiceMissing: Boolean,
        val picture: Picture = Picture(),
        val lengths: LengthStyle = LengthStyle.FEET,
    ) : LiveUiState
}
