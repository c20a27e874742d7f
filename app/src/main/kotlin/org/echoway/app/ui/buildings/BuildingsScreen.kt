package org.echoway.app.ui.buildings

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.pluralStringResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.building.ImportProblem
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.AskDelete
import org.echoway.app.ui.common.Choice
import org.echoway.app.ui.common.NamedAction
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Subheading

/** What the wearer can do with buildings. */
data class BuildingsActions(
    val onImportZip: () -> Unit,
    val onImportFolder: () -> Unit,
    val onChoose: (BuildingItem) -> Unit,
    val onCheck: (BuildingItem) -> Unit,
    val onAskDelete: (BuildingItem?) -> Unit,
    val onDelete: (BuildingItem) -> Unit,
    val onEntrance: () -> Unit,
    val onBack: () -> Unit,
)

@Composable
fun BuildingsScreen(state: BuildingsUiState, actions: BuildingsActions) {
    Screen(stringResource(R.string.buildings), actions.onBack) {
        state.notice?.let { Notice(it) }
        state.buildings?.forEach { item ->
            Building(item, actions)
            HorizontalDivider()
        }
        Action(stringResource(R.string.import_zip), onClick = actions.onImportZip)
        Action(stringResource(R.string.import_folder), onClick = actions.onImportFolder)
    }
    state.askDelete?.let { item -> AskDelete(item.title, { actions.onAskDelete(null) }) { actions.onDelete(item) } }
}

@Composable
private fun Building(item: BuildingItem, actions: BuildingsActions) {
    Column(verticalArrangement = Arrangement.spacedBy(8.dp)) {
        Choice(item.title, item.chosen) { actions.onChoose(item) }
        val rooms = pluralStringResource(R.plurals.rooms, item.rooms, item.rooms)
        val exits = pluralStringResource(R.plurals.exits, item.exits, item.exits)
        Text(stringResource(R.string.building_size, rooms, exits), style = MaterialTheme.typography.bodyLarge)
        if (item.chosen && item.exits > 0) {
            Action(stringResource(R.string.choose_entrance), onClick = actions.onEntrance)
        }
        FlowRow(horizontalArrangement = Arrangement.spacedBy(12.dp)) {
            NamedAction(stringResource(R.string.check_building), item.title) { actions.onCheck(item) }
            if (item.imported) NamedAction(stringResource(R.string.delete), item.title) { actions.onAskDelete(item) }
        }
    }
}

@Composable
private fun Notice(notice: BuildingNotice) {
    Column(Modifier.semantics { liveRegion = LiveRegionMode.Polite }, Arrangement.spacedBy(8.dp)) {
        when (notice) {
            BuildingNotice.Working -> Text(stringResource(R.string.working))
            is BuildingNotice.Imported -> {
                Subheading(stringResource(R.string.imported, notice.title))
                Findings(notice.findings)
            }
            is BuildingNotice.Checked -> {
                Subheading(stringResource(R.string.checked, notice.title))
                Findings(notice.findings)
            }
            is BuildingNotice.Unusable -> {
                Subheading(stringResource(R.string.import_refused))
                Text(stringResource(R.string.problem_unusable), color = MaterialTheme.colorScheme.error)
                Findings(notice.findings)
            }
            is BuildingNotice.Refused -> {
                Subheading(stringResource(R.string.import_refused))
                Text(stringResource(notice.problem.words), color = MaterialTheme.colorScheme.error)
                if (notice.problem in NAMES_A_FILE && notice.detail.isNotEmpty()) {
                    Text(stringResource(R.string.problem_file, notice.detail))
                }
            }
            is BuildingNotice.Deleted -> Text(stringResource(R.string.deleted, notice.title))
        }
    }
}

private val NAMES_A_FILE = setOf(ImportProblem.UNSAFE_NAME, ImportProblem.DUPLICATE_NAME, ImportProblem.BAD_NAME)

private val ImportProblem.words
    get() = when (this) {
        ImportProblem.UNREADABLE -> R.string.problem_unreadable
        ImportProblem.UNSAFE_NAME -> R.string.problem_unsafe_name
        ImportProblem.BAD_NAME -> R.string.problem_bad_name
        ImportProblem.DUPLICATE_NAME -> R.string.problem_duplicate_name
        ImportProblem.TOO_MANY_FILES -> R.string.problem_too_many_files
        ImportProblem.TOO_LARGE -> R.string.problem_too_large
        ImportProblem.ENCRYPTED -> R.string.problem_encrypted
        ImportProblem.NO_BUILDING -> R.string.problem_no_building
        ImportProblem.SEVERAL_BUILDINGS -> R.string.problem_several_buildings
        ImportProblem.DISK_FULL -> R.string.problem_disk_full
    }
