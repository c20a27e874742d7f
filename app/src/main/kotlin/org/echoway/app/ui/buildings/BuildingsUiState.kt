package org.echoway.app.ui.buildings

import org.echoway.app.building.ImportProblem
import org.echoway.core.Finding

/** A building in the list. */
data class BuildingItem(
    val id: String,
    val title: String,
    val rooms: Int,
    val exits: Int,
    val imported: Boolean,
    val chosen: Boolean,
)

/** What came of the newest wish. */
sealed interface BuildingNotice {
    data object Working : BuildingNotice

    data class Imported(val title: String, val findings: List<Finding>) : BuildingNotice

    data class Refused(val problem: ImportProblem, val detail: String) : BuildingNotice

    data class Unusable(val findings: List<Finding>) : BuildingNotice

    data class Checked(val title: String, val findings: List<Finding>) : BuildingNotice

    data class Deleted(val title: String) : BuildingNotice
}

/** What the buildings screen shows; null [buildings] while they are being read. */
data class BuildingsUiState(
    val buildings: List<BuildingItem>? = null,
    val notice: BuildingNotice? = null,
    val askDelete: BuildingItem? = null,
)
