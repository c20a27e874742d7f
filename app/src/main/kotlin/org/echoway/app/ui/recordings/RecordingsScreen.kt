package org.echoway.app.ui.recordings

import android.text.format.Formatter
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.platform.LocalContext
import androidx.compose.ui.res.pluralStringResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import java.time.format.DateTimeFormatter
import java.time.format.FormatStyle
import kotlin.math.roundToInt
import org.echoway.app.R
import org.echoway.app.recording.Recording
import org.echoway.app.recording.RecordingStatus
import org.echoway.app.ui.common.AskDelete
import org.echoway.app.ui.common.NamedAction
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Subheading
import org.echoway.app.ui.common.Toggle

/** What the wearer can do with recordings. */
data class RecordingsActions(
    val onRecord: (Boolean) -> Unit,
    val onReplay: (Recording) -> Unit,
    val onShare: (Recording) -> Unit,
    val onAskDelete: (Recording?) -> Unit,
    val onDelete: (Recording) -> Unit,
    val onBack: () -> Unit,
)

@Composable
fun RecordingsScreen(state: RecordingsUiState, actions: RecordingsActions) {
    Screen(stringResource(R.string.recordings), actions.onBack) {
        Toggle(stringResource(R.string.setting_record), state.recordWalks, actions.onRecord)
        Text(stringResource(R.string.recordings_stay), style = MaterialTheme.typography.bodyLarge)
        Status(state.status)
        if (state.all?.isEmpty() == true) {
            Text(stringResource(R.string.no_recordings), style = MaterialTheme.typography.bodyLarge)
        }
        state.all?.forEach { recording ->
            HorizontalDivider()
            Item(recording, (state.status as? RecordingStatus.On)?.name == recording.name, actions)
        }
    }
    state.askDelete?.let { recording ->
        AskDelete(title(recording), { actions.onAskDelete(null) }) { actions.onDelete(recording) }
    }
}

@Composable
private fun Status(status: RecordingStatus) {
    val words = when (status) {
        RecordingStatus.Off -> return
        is RecordingStatus.On -> stringResource(R.string.recording_now)
        is RecordingStatus.Failed ->
            if (status.diskFull) {
                stringResource(R.string.recording_disk_full)
            } else {
                stringResource(R.string.recording_failed, status.reason)
            }
    }
    val failed = status is RecordingStatus.Failed
    val colours = MaterialTheme.colorScheme
    Text(
        words,
        Modifier.semantics { liveRegion = if (failed) LiveRegionMode.Assertive else LiveRegionMode.Polite },
        color = if (failed) colours.error else colours.onSurface,
        style = MaterialTheme.typography.titleMedium,
    )
}

@Composable
private fun Item(recording: Recording, running: Boolean, actions: RecordingsActions) {
    val title = title(recording)
    Column(verticalArrangement = Arrangement.spacedBy(8.dp)) {
        Subheading(title)
        Text(description(recording), style = MaterialTheme.typography.bodyLarge)
        if (!running) {
            FlowRow(horizontalArrangement = Arrangement.spacedBy(12.dp)) {
                NamedAction(stringResource(R.string.replay), title) { actions.onReplay(recording) }
                NamedAction(stringResource(R.string.share), title) { actions.onShare(recording) }
                NamedAction(stringResource(R.string.delete), title) { actions.onAskDelete(recording) }
            }
        }
    }
}

@Composable
private fun title(recording: Recording): String {
    val locale = LocalConfiguration.current.locales[0]
    return recording.startedAt?.format(
        DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.SHORT).withLocale(locale),
    )
        ?: recording.name
}

@Composable
private fun description(recording: Recording): String {
    val seconds = recording.durationS?.roundToInt()
    val length = seconds?.let {
        if (it < SECONDS_PER_MINUTE) pluralStringResource(R.plurals.seconds, it, it)
        else (it / SECONDS_PER_MINUTE).let { minutes -> pluralStringResource(R.plurals.minutes, minutes, minutes) }
    }
    val size = Formatter.formatShortFileSize(LocalContext.current, recording.bytes)
    return listOfNotNull(recording.building, length, size).joinToString(", ")
}

private const val SECONDS_PER_MINUTE = 60
