package org.echoway.app.ui.firefighter

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.BasicText
import androidx.compose.foundation.text.TextAutoSize
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Surface
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.echoway.app.R
import org.echoway.app.control.Stillness
import org.echoway.app.guide.Ask
import org.echoway.app.settings.ThemeChoice
import org.echoway.app.ui.EchowayTheme
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.VoiceMissing

/**
 * What firefighter mode shows.
 *
 * @property words the state in words
 * @property lastLine what was said last
 * @property running whether guidance is on
 * @property voiceMissing the phone cannot speak
 */
data class FirefighterUiState(
    val words: String,
    val lastLine: String,
    val running: Boolean,
    val stillness: Stillness,
    val voiceMissing: Boolean = false,
)

data class FirefighterActions(
    val onAsk: (Ask) -> Unit,
    val onStart: () -> Unit,
    val onCancelAlarm: () -> Unit,
    val onLeave: () -> Unit,
)

/** One dark screen; three things to press, each as large as a gloved hand. While the wearer does not move, one. */
@Composable
fun FirefighterScreen(state: FirefighterUiState, actions: FirefighterActions) = EchowayTheme(ThemeChoice.SMOKE) {
    Surface(Modifier.fillMaxSize()) {
        if (LocalConfiguration.current.screenHeightDp < LOW_DP) Beside(state, actions) else Below(state, actions)
    }
}

@Composable
private fun Below(state: FirefighterUiState, actions: FirefighterActions) {
    Column(Modifier.safeDrawingPadding().padding(12.dp), Arrangement.spacedBy(12.dp)) {
        Words(state)
        Buttons(state, actions)
        Leave(actions)
    }
}

/** On a phone that lies on its side the words make way, not the buttons. */
@Composable
private fun Beside(state: FirefighterUiState, actions: FirefighterActions) {
    Row(Modifier.safeDrawingPadding().padding(12.dp), Arrangement.spacedBy(12.dp)) {
        Column(Modifier.weight(1f).fillMaxHeight().verticalScroll(rememberScrollState()), Arrangement.spacedBy(12.dp)) {
            Words(state)
            Leave(actions)
        }
        Column(Modifier.weight(1f).fillMaxHeight(), Arrangement.spacedBy(12.dp)) { Buttons(state, actions) }
    }
}

@Composable
private fun Words(state: FirefighterUiState) {
    val type = MaterialTheme.typography
    Line(stringResource(R.string.firefighter), type.titleLarge, Modifier.semantics { heading() })
    Line(state.words, type.headlineSmall)
    if (state.voiceMissing) VoiceMissing()
    if (state.stillness != Stillness.MOVING) {
        val alarm = if (state.stillness == Stillness.ALARM) R.string.still_alarm else R.string.still_soon
        Line(stringResource(alarm), type.headlineMedium, Modifier.semantics { liveRegion = LiveRegionMode.Assertive })
    } else if (state.running) {
        Line(state.lastLine, type.titleMedium)
    }
}

@Composable
private fun ColumnScope.Buttons(state: FirefighterUiState, actions: FirefighterActions) = when {
    state.stillness != Stillness.MOVING -> GloveButton(stringResource(R.string.cancel_alarm), actions.onCancelAlarm)
    state.running -> {
        GloveButton(stringResource(R.string.nearest_exit)) { actions.onAsk(Ask.WAY_OUT) }
        GloveButton(stringResource(R.string.way_back_short)) { actions.onAsk(Ask.WAY_BACK) }
        GloveButton(stringResource(R.string.where_am_i)) { actions.onAsk(Ask.WHERE_AM_I) }
    }
    else -> GloveButton(stringResource(R.string.start), actions.onStart)
}

@Composable
private fun Leave(actions: FirefighterActions) {
    Line(stringResource(R.string.not_a_pass), MaterialTheme.typography.bodyMedium)
    Action(stringResource(R.string.firefighter_leave), onClick = actions.onLeave)
}

@Composable
private fun Line(text: String, style: TextStyle, modifier: Modifier = Modifier) =
    Text(text, modifier.fillMaxWidth(), style = style, textAlign = TextAlign.Center)

@Composable
private fun ColumnScope.GloveButton(text: String, onClick: () -> Unit) {
    Button(
        onClick,
        Modifier.weight(1f).fillMaxWidth().heightIn(min = GLOVE),
        shape = RoundedCornerShape(16.dp),
        colors = ButtonDefaults.buttonColors(
            containerColor = MaterialTheme.colorScheme.primary, contentColor = Color.Black,
        ),
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

/** Three gloved palms, the words and the way out of it need more. */
private const val LOW_DP = 600
private val SMALLEST = 16.sp
