package org.echoway.app.ui.buildings

import android.content.Context
import android.net.Uri
import android.provider.DocumentsContract
import android.provider.OpenableColumns
import androidx.activity.compose.rememberLauncherForActivityResult
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.OpenDocumentTree
import androidx.compose.runtime.getValue
import androidx.compose.ui.platform.LocalContext
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import java.io.FileNotFoundException
import org.echoway.app.AppContainer
import org.echoway.app.building.ImportLimits
import org.echoway.app.building.PickedFolder
import org.echoway.app.ui.Route

/** The buildings screen with the system's pickers. */
fun NavGraphBuilder.buildings(container: AppContainer, open: (Route) -> Unit, back: () -> Unit) {
    composable<Route.Buildings> {
        val context = LocalContext.current
        val model = viewModel { BuildingsViewModel(container.buildings, container.settings) }
        val state by model.uiState.collectAsStateWithLifecycle()
        val zip = rememberLauncherForActivityResult(OpenDocument()) { uri ->
            uri?.let { picked ->
                model.importZip(context.nameOf(picked)) {
                    context.contentResolver.openInputStream(picked) ?: throw FileNotFoundException(picked.toString())
                }
            }
        }
        val folder = rememberLauncherForActivityResult(OpenDocumentTree()) { uri ->
            uri?.let { picked ->
                val root = DocumentsContract.buildDocumentUriUsingTree(picked, DocumentsContract.getTreeDocumentId(picked))
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

/** What its provider calls a document. */
internal fun Context.nameOf(uri: Uri): String =
    runCatching { contentResolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null) }.getOrNull()
        ?.use { if (it.moveToFirst()) it.getString(0) else null }
        .orEmpty()

/** Providers disagree on what a zip archive is. */
private val ZIP_TYPES = arrayOf("application/zip", "application/x-zip-compressed", "application/octet-stream")
