package org.echoway.app.ui.buildings

import android.provider.DocumentsContract
import androidx.activity.compose.rememberLauncherForActivityResult
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.OpenDocumentTree
import androidx.compose.runtime.getValue
import androidx.compose.ui.platform.LocalContext
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import org.echoway.app.AppContainer
import org.echoway.app.building.ImportLimits
import org.echoway.app.building.PickedFolder
import org.echoway.app.nameOf
import org.echoway.app.openPicked
import org.echoway.app.ui.Route

/** The buildings screen with the system's pickers. */
fun NavGraphBuilder.buildings(container: AppContainer, open: (Route) -> Unit, back: () -> Unit) {
    composable<Route.Buildings> {
        val context = LocalContext.current
        val model = viewModel { BuildingsViewModel(container.buildings, container.settings) }
        val state by model.uiState.collectAsStateWithLifecycle()
        val zip = rememberLauncherForActivityResult(OpenDocument()) { uri ->
            uri?.let { picked ->
                model.importZip(context.nameOf(picked)) { context.contentResolver.openPicked(picked) }
            }
        }
        val folder = rememberLauncherForActivityResult(OpenDocumentTree()) { uri ->
            uri?.let { picked ->
                val root =
                    DocumentsContract.buildDocumentUriUsingTree(picked, DocumentsContract.getTreeDocumentId(picked))
                model.importFolder(context.nameOf(root), PickedFolder(context.contentResolver, picked, ImportLimits()))
            }
        }
        BuildingsScreen(
            state,
            BuildingsActions(
                onImportZip = { zip.launch(ZIP_TYPES) },
                onImportFolder = { folder.launch(null) },
                onChoose = model::choose,
                onCheck = model::check,
                onAskDelete = model::askDelete,
                onDelete = model::delete,
                onEntrance = { open(Route.Setup) },
                onBack = back,
            ),
        )
    }
}

/** Providers disagree on what a zip archive is. */
private val ZIP_TYPES = arrayOf("application/zip", "application/x-zip-compressed", "application/octet-stream")
