package org.echoway.app.ui.firefighter

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicText
import androidx.compose.foundation.text.TextAutoSize
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.echoway.app.R
import org.echoway.app.control.Stillness
import org.echoway.app.guide.Ask
import org.echoway.app.settings.ThemeChoice
import org.echoway.app.ui.EchowayTheme
import org.echoway.app.ui.common.Action

/**
 * What firefighter mode shows.
 *
 * @property words the state in words
 * @property lastLine what was said last
 * @property running whether guidance is on
 */
data class FirefighterUiState(val words: String, val lastLine: String, val running: Boolean, val stillness: Stillness)

data class FirefighterActions(val onAsk: (Ask) -> Unit, val onStart: () -> Unit, val onCancelAlarm: () -> Unit, val onLeave: () -> Unit)

/** One dark screen; three things to press, each as large as a gloved hand. While the wearer does not move, one. */
@Composable
fun FirefighterScreen(state: FirefighterUiState, actions: FirefighterActions) = EchowayTheme(ThemeChoice.SMOKE) {
    Surface(Modifier.fillMaxSize()) {
        Column(Modifier.safeDrawingPadding().padding(12.dp), Arrangement.spacedBy(12.dp)) {
            Text(
                stringResource(R.string.firefighter),
                Modifier.fillMaxWidth().semantics { heading() },
                style = MaterialTheme.typography.titleLarge,
                textAlign = TextAlign.Center,
            )
            Text(state.words, Modifier.fillMaxWidth(), style = MaterialTheme.typography.headlineSmall, textAlign = TextAlign.Center)
            when {
                state.stillness != Stillness.MOVING -> Alarm(state.stillness, actions.onCancelAlarm)
                state.running -> Asks(state.lastLine, actions.onAsk)
                else -> GloveButton(stringResource(R.string.start), actions.onStart)
            }
            Text(
                stringResource(R.string.not_a_pass),
                Modifier.fillMaxWidth(),
                style = MaterialTheme.typography.bodyMedium,
                textAlign = TextAlign.Center,
            )
            Action(stringResource(R.string.firefighter_leave), onClick = actions.onLeave)
        }
    }
}

@Composable
private fun ColumnScope.Asks(lastLine: String, onAsk: (Ask) -> Unit) {
    Text(lastLine, Modifier.fillMaxWidth(), style = MaterialTheme.typography.titleMedium, textAlign = TextAlign.Center)
    GloveButton(stringResource(R.string.nearest_exit)) { onAsk(Ask.WAY_OUT) }
    GloveButton(stringResource(R.string.way_back_short)) { onAsk(Ask.WAY_BACK) }
    GloveButton(stringResource(R.string.where_am_i)) { onAsk(Ask.WHERE_AM_I) }
}

@Composable
private fun ColumnScope.Alarm(stillness: Stillness, onCancel: () -> Unit) {
    val words = if (stillness == Stillness.ALARM) R.string.still_alarm else R.string.still_soon
    Text(
        stringResource(words),
        Modifier.fillMaxWidth().semantics { liveRegion = LiveRegionMode.Assertive },
        style = MaterialTheme.typography.headlineMedium,
        textAlign = TextAlign.Center,
    )
    GloveButton(stringResource(R.string.cancel_alarm), onCancel)
}

@Composable
private fun ColumnScope.GloveButton(text: String, onClick: () -> Unit) {
    Button(
        onClick,
        Modifier.weight(1f).fillMaxWidth().heightIn(min = GLOVE),
        shape = RoundedCornerShape(16.dp),
        colors = ButtonDefaults.buttonColors(containerColor = MaterialTheme.colorScheme.primary, contentColor = Color.Black),
    ) {
        // As large as it fits: large letters of a wearer who asks for them must not be cut.
        BasicText(
            text,
            style = MaterialTheme.typography.displaySmall.copy(color = Color.Black, textAlign = TextAlign.Center),
            autoSize = TextAutoSize.StepBased(SMALLEST, MaterialTheme.typography.displaySmall.fontSize),
        )
    }
}

/** The breadth of a gloved palm. */
private val GLOVE = 96.dp
private val SMALLEST = 16.sp
