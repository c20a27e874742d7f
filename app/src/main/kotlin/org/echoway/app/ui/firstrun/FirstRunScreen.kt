package org.echoway.app.ui.firstrun

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.BigButton
import org.echoway.app.ui.common.Heading

/** What can be done in the first run. */
data class FirstRunActions(
    val onNext: () -> Unit,
    val onBack: () -> Unit,
    val onAgain: () -> Unit,
    val onSkip: () -> Unit,
    val onPractise: () -> Unit,
)

/** One step, in words that are spoken too; what leads on is always the lowest and largest thing on the screen. */
@Composable
fun FirstRunScreen(step: FirstRunStep, actions: FirstRunActions) {
    Surface(Modifier.fillMaxSize()) {
        Column(Modifier.safeDrawingPadding().padding(16.dp), Arrangement.spacedBy(12.dp)) {
            Column(Modifier.weight(1f).verticalScroll(rememberScrollState()), Arrangement.spacedBy(12.dp)) {
                Heading(stringResource(step.title))
                Text(
                    stringResource(R.string.intro_step, step.ordinal + 1, FirstRunStep.entries.size),
                    style = MaterialTheme.typography.titleMedium,
                )
                Text(stringResource(step.words), style = MaterialTheme.typography.bodyLarge)
            }
            // Side by side where their words fit, below each other where they are large.
            FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp), Arrangement.spacedBy(8.dp)) {
                Action(stringResource(R.string.intro_again), Modifier, onClick = actions.onAgain)
                if (step.ordinal > 0) Action(stringResource(R.string.intro_back), Modifier, onClick = actions.onBack)
                Action(stringResource(R.string.intro_skip), Modifier, onClick = actions.onSkip)
            }
            if (step == FirstRunStep.PRACTICE) {
                BigButton(stringResource(R.string.intro_start_practice), onClick = actions.onPractise)
            } else {
                BigButton(stringResource(R.string.intro_next), onClick = actions.onNext)
            }
        }
    }
}
