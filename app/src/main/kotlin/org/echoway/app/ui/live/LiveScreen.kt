package org.echoway.app.ui.live

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
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
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalConfiguration
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.isTraversalGroup
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.traversalIndex
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.engine.Picture
import org.echoway.app.ui.common.Action
import org.echoway.app.ui.common.BigButton
import org.echoway.app.ui.common.Heading
import org.echoway.app.ui.common.VoiceMissing
import org.echoway.app.ui.map.LevelMap
import org.echoway.app.ui.map.MapControls
import org.echoway.app.ui.map.rememberMapCamera
import org.echoway.core.Estimate
import org.echoway.core.LengthStyle
import org.echoway.core.Plan

/** What the wearer can ask of the live screen. */
data class LiveActions(
    val onWhereAmI: () -> Unit,
    val onStart: () -> Unit,
    val onStop: () -> Unit,
    val onSetup: () -> Unit,
    val onMenu: () -> Unit,
)

/** Map, state in words, and a button that can be found without looking. */
@Composable
fun LiveScreen(state: LiveUiState, actions: LiveActions) {
    Surface(Modifier.fillMaxSize()) {
        Column(
            Modifier.safeDrawingPadding().padding(16.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
            horizontalAlignment = Alignment.CenterHorizontally,
        ) {
            when (state) {
                LiveUiState.Loading -> Unit
                LiveUiState.NeedsSetup -> Notice(stringResource(R.string.choose_building_first), actions)
                is LiveUiState.Failed -> Failed(state, actions)
                is LiveUiState.Off -> Off(state, actions)
                is LiveUiState.On -> On(state, actions)
            }
        }
    }
}

@Composable
private fun ColumnScope.Notice(text: String, actions: LiveActions) {
    Heading(text, Modifier.weight(1f).semantics { liveRegion = LiveRegionMode.Polite })
    BigButton(stringResource(R.string.setup), onClick = actions.onSetup)
    Action(stringResource(R.string.menu), onClick = actions.onMenu)
}

/** What was wrong may be mended by now: without a way to begin again the wearer would be stuck here. */
@Composable
private fun ColumnScope.Failed(state: LiveUiState.Failed, actions: LiveActions) {
    Column(Modifier.weight(1f).verticalScroll(rememberScrollState()), Arrangement.spacedBy(12.dp)) {
        Heading(state.words, Modifier.semantics { liveRegion = LiveRegionMode.Polite })
        Text(state.reason, style = MaterialTheme.typography.bodyLarge)
    }
    BigButton(stringResource(R.string.start), onClick = actions.onStart)
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
        Action(stringResource(R.string.setup), Modifier.weight(1f), onClick = actions.onSetup)
        Action(stringResource(R.string.menu), Modifier.weight(1f), onClick = actions.onMenu)
    }
}

@Composable
private fun ColumnScope.Off(state: LiveUiState.Off, actions: LiveActions) {
    Heading(state.building)
    BesideOrBelow(
        map = { Map(state.building, state.plan, state.plan.rooms.first().level, null, Picture(), state.lengths, it) },
    ) {
        Text(stringResource(R.string.state_off), style = MaterialTheme.typography.titleMedium)
        if (state.voiceMissing) {
            VoiceMissing()
            // On the way there is no time for it.
            Text(
                stringResource(R.string.voice_missing_mend),
                style = MaterialTheme.typography.bodyMedium,
                textAlign = TextAlign.Center,
            )
        }
        BigButton(stringResource(R.string.start), onClick = actions.onStart)
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
            Action(stringResource(R.string.setup), Modifier.weight(1f), onClick = actions.onSetup)
            Action(stringResource(R.string.menu), Modifier.weight(1f), onClick = actions.onMenu)
        }
    }
}

@Composable
private fun ColumnScope.On(state: LiveUiState.On, actions: LiveActions) {
    Heading(state.building)
    BesideOrBelow(
        map = { Map(state.building, state.plan, state.level, state.wearer, state.picture, state.lengths, it) },
    ) {
        // The voice says this already; TalkBack reads it on demand instead of talking over the guidance.
        Text(state.words, style = MaterialTheme.typography.headlineSmall, textAlign = TextAlign.Center)
        if (state.lastLine.isNotEmpty() && state.lastLine != state.words) {
            Text(state.lastLine, style = MaterialTheme.typography.bodyLarge, textAlign = TextAlign.Center)
        }
        if (state.voiceMissing) VoiceMissing()
        BigButton(stringResource(R.string.where_am_i), onClick = actions.onWhereAmI)
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp)) {
            Action(stringResource(R.string.stop), Modifier.weight(1f), onClick = actions.onStop)
            Action(stringResource(R.string.menu), Modifier.weight(1f), onClick = actions.onMenu)
        }
    }
}

/**
 * The map above the rest, or beside it where the screen is wide and low. A screen reader comes to the map last: all its
 * rooms would stand between a wearer and what they can press.
 */
@Composable
private fun ColumnScope.BesideOrBelow(map: @Composable (Modifier) -> Unit, rest: @Composable ColumnScope.() -> Unit) {
    val window = LocalConfiguration.current
    val last = Modifier.semantics {
        isTraversalGroup = true
        traversalIndex = 1f
    }
    if (window.screenWidthDp > window.screenHeightDp && window.screenWidthDp >= WIDE_DP) {
        Row(Modifier.weight(1f).fillMaxWidth(), Arrangement.spacedBy(16.dp), Alignment.Bottom) {
            map(last.weight(1.4f).fillMaxHeight())
            // From the bottom up: where large words do not fit, what can be pressed is still there.
            val words = Modifier.weight(1f).verticalScroll(rememberScrollState(), reverseScrolling = true)
            Column(words, Arrangement.spacedBy(12.dp), Alignment.CenterHorizontally, rest)
        }
    } else {
        map(last.weight(1f).fillMaxWidth())
        rest()
    }
}

/** The map of the level where the wearer is, or of another that they look at. */
@Composable
private fun Map(
    title: String,
    plan: Plan,
    level: Int,
    wearer: Estimate?,
    picture: Picture,
    lengths: LengthStyle,
    modifier: Modifier,
) {
    val camera = rememberMapCamera()
    // A new level under the wearer's feet is a new picture; until then they may look at others.
    var shown by rememberSaveable(level) { mutableIntStateOf(level) }
    val levels = remember(plan) { plan.rooms.map { it.level }.distinct().sorted() }
    Column(modifier, horizontalAlignment = Alignment.CenterHorizontally) {
        LevelMap(title, plan, shown, wearer, picture, lengths, camera, Modifier.weight(1f).fillMaxWidth())
        MapControls(camera, wearer != null, levels, shown, { shown = it })
    }
}

private const val WIDE_DP = 700
