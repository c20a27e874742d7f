package org.echoway.app.ui.recordings

import android.content.ClipData
import android.content.Context
import android.content.Intent
import android.net.Uri
import androidx.compose.runtime.getValue
import androidx.compose.ui.platform.LocalContext
import androidx.core.content.FileProvider
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.compose.viewModel
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import java.io.File
import org.echoway.app.AppContainer
import org.echoway.app.ui.Route

/** The recordings screen with the system's sheet for sharing. [start] starts guidance. */
fun NavGraphBuilder.recordings(container: AppContainer, start: () -> Unit, open: (Route) -> Unit, back: () -> Unit) {
    composable<Route.Recordings> {
        val context = LocalContext.current
        val model = viewModel { RecordingsViewModel(container.recordings, container.settings) }
        val state by model.uiState.collectAsStateWithLifecycle()
        RecordingsScreen(
            state,
            RecordingsActions(
                onRecord = model::record,
                onReplay = { recording ->
                    model.replay(recording) {
                        start()
                        open(Route.Live)
                    }
                },
                onShare = {
                    context.startActivity(
                        Intent.createChooser(share(context, container.recordings.files(it.name)), null),
                    )
                },
                onAskDelete = model::askDelete,
                onDelete = model::delete,
                onBack = back,
            ),
        )
    }
}

/** All files of a recording to whatever app the wearer picks; that app may read these and nothing else. */
internal fun share(context: Context, files: List<File>): Intent {
    val uris = ArrayList<Uri>(files.map { FileProvider.getUriForFile(context, "${context.packageName}.files", it) })
    return Intent(Intent.ACTION_SEND_MULTIPLE)
        .setType("text/csv")
        .putParcelableArrayListExtra(Intent.EXTRA_STREAM, uris)
        .addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
        .apply {
            clipData = ClipData.newRawUri(null, uris.first()).also { clip ->
                uris.drop(1).forEach { clip.addItem(ClipData.Item(it)) }
            }
        }
}
