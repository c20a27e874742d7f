package org.echoway.app.ui.belt

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalResources
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Subheading
import org.echoway.core.ExplainedEcho
import org.echoway.core.LengthStyle

/** The newest reading of each sensor around the wearer, and what explains it: as a picture and in words. */
@Composable
fun BeltScreen(scan: List<ExplainedEcho>, lengths: LengthStyle, onBack: () -> Unit) {
    val resources = LocalResources.current
    val readings = remember(resources, lengths) { BeltReadings(resources, lengths) }
    Screen(stringResource(R.string.belt_view), onBack) {
        val summary = if (scan.isEmpty()) stringResource(R.string.belt_off) else readings.summary(scan)
        Text(summary, style = MaterialTheme.typography.titleMedium)
        if (scan.isNotEmpty()) {
            val colours = BeltColours.of(MaterialTheme.colorScheme)
            Canvas(
                Modifier.widthIn(max = 480.dp).fillMaxWidth().aspectRatio(1f).align(Alignment.CenterHorizontally)
                    .semantics { contentDescription = summary },
            ) { drawBelt(scan, colours) }
            Subheading(stringResource(R.string.readings))
            scan.indices.forEach { Text(readings.words(it, scan), style = MaterialTheme.typography.bodyLarge) }
            Legend(colours)
        }
    }
}
