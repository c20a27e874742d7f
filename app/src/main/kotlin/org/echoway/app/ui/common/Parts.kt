package org.echoway.app.ui.common

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.AlertDialog
import androidx.compose.material3.Button
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.RadioButton
import androidx.compose.material3.Surface
import androidx.compose.material3.Switch
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.echoway.app.R

/** What must be found without looking. */
val BIG_TARGET = 120.dp

/** Longer lines are hard to read on a tablet. */
private val READABLE = 640.dp

/** A screen with a heading, content that scrolls, and "Back" where the thumb is. */
@Composable
fun Screen(title: String, onBack: () -> Unit, content: @Composable ColumnScope.() -> Unit) {
    Frame(title, onBack) {
        Column(
            Modifier.weight(1f).widthIn(max = READABLE).fillMaxWidth().verticalScroll(rememberScrollState()),
            Arrangement.spacedBy(12.dp),
            content = content,
        )
    }
}

/** A screen whose content takes the space that there is, and does not scroll by itself. */
@Composable
fun Frame(title: String, onBack: () -> Unit, content: @Composable ColumnScope.() -> Unit) {
    Surface(Modifier.fillMaxSize()) {
        Column(
            Modifier.safeDrawingPadding().padding(16.dp),
            verticalArrangement = Arrangement.spacedBy(12.dp),
            horizontalAlignment = Alignment.CenterHorizontally,
        ) {
            Heading(title)
            content()
            Action(stringResource(R.string.back), Modifier.widthIn(max = READABLE).fillMaxWidth(), onClick = onBack)
        }
    }
}

@Composable
fun Heading(text: String, modifier: Modifier = Modifier) {
    Text(
        text,
        modifier.semantics { heading() },
        style = MaterialTheme.typography.headlineSmall,
        textAlign = TextAlign.Center,
    )
}

@Composable
fun Subheading(text: String, modifier: Modifier = Modifier) {
    Text(text, modifier.semantics { heading() }, style = MaterialTheme.typography.titleLarge)
}

/** The one thing to do on a screen. */
@Composable
fun BigButton(text: String, modifier: Modifier = Modifier, onClick: () -> Unit) {
    Button(onClick, modifier.fillMaxWidth().heightIn(min = BIG_TARGET)) {
        Text(text, style = MaterialTheme.typography.headlineMedium, textAlign = TextAlign.Center)
    }
}

/** One of the other things. */
@Composable
fun Action(text: String, modifier: Modifier = Modifier.fillMaxWidth(), enabled: Boolean = true, onClick: () -> Unit) {
    OutlinedButton(onClick, modifier.heightIn(min = 56.dp), enabled) {
        Text(text, style = MaterialTheme.typography.bodyLarge, textAlign = TextAlign.Center)
    }
}

/** An action whose words stand below each thing in a list; who does not see them together hears of which one. */
@Composable
fun NamedAction(text: String, of: String, onClick: () -> Unit) {
    Action(text, Modifier.semantics { contentDescription = "$text: $of" }, onClick = onClick)
}

/** What nobody can be told aloud. Short: in firefighter mode large letters share the screen with large buttons. */
@Composable
fun VoiceMissing() {
    Text(
        stringResource(R.string.voice_missing),
        Modifier.fillMaxWidth().semantics { liveRegion = LiveRegionMode.Polite },
        color = MaterialTheme.colorScheme.error,
        style = MaterialTheme.typography.bodyMedium,
        textAlign = TextAlign.Center,
    )
}

/** Asks before something is gone for good. */
@Composable
fun AskDelete(what: String, onKeep: () -> Unit, onDelete: () -> Unit) {
    AlertDialog(
        onDismissRequest = onKeep,
        title = { Heading(stringResource(R.string.ask_delete, what)) },
        confirmButton = { Action(stringResource(R.string.delete), Modifier, onClick = onDelete) },
        dismissButton = { Action(stringResource(R.string.keep), Modifier, onClick = onKeep) },
    )
}

/** One of several to choose; inside a [Choices]. */
@Composable
fun Choice(title: String, chosen: Boolean, enabled: Boolean = true, onChoose: () -> Unit) {
    Row(
        Modifier.fillMaxWidth().heightIn(min = 56.dp).selectable(chosen, enabled, Role.RadioButton, onClick = onChoose),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        // The whole row is the target; a second one inside it would be read twice.
        RadioButton(chosen, onClick = null, Modifier.padding(horizontal = 12.dp), enabled)
        val colours = MaterialTheme.colorScheme
        Text(
            title,
            style = MaterialTheme.typography.bodyLarge,
            color = if (enabled) colours.onSurface else colours.onSurfaceVariant,
        )
    }
}

/** Choices of which one holds, under a heading. */
@Composable
fun Choices(title: String, choices: @Composable () -> Unit) {
    Column(Modifier.selectableGroup()) {
        Subheading(title)
        choices()
    }
}

/** Something that is on or off. */
@Composable
fun Toggle(title: String, on: Boolean, onToggle: (Boolean) -> Unit) {
    Row(
        Modifier.fillMaxWidth().heightIn(min = 56.dp).toggleable(on, role = Role.Switch, onValueChange = onToggle),
        Arrangement.spacedBy(12.dp),
        Alignment.CenterVertically,
    ) {
        Text(title, Modifier.weight(1f), style = MaterialTheme.typography.bodyLarge)
        Switch(on, onCheckedChange = null)
    }
}
