package org.echoway.app.ui.practice

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.unit.dp
import org.echoway.app.R
import org.echoway.app.touch.Touch
import org.echoway.app.ui.common.Screen

/** Every signal with its name and how it feels; a tap lets one feel and hear it. */
@Composable
fun PracticeScreen(canVibrate: Boolean, onPractise: (Touch, String) -> Unit, onBack: () -> Unit) {
    Screen(stringResource(R.string.practice), onBack) {
        Text(
            stringResource(if (canVibrate) R.string.practice_hint else R.string.no_vibrator),
            style = MaterialTheme.typography.bodyLarge,
        )
        Touch.entries.forEach { Signal(it, onPractise) }
    }
}

@Composable
private fun Signal(touch: Touch, onPractise: (Touch, String) -> Unit) {
    val name = stringResource(touch.title)
    val feel = stringResource(touch.feel)
    val explained = stringResource(R.string.touch_explained, name, feel)
    OutlinedButton({ onPractise(touch, explained) }, Modifier.fillMaxWidth().heightIn(min = 72.dp)) {
        Column(Modifier.fillMaxWidth().padding(vertical = 8.dp), horizontalAlignment = Alignment.Start) {
            Text(name, style = MaterialTheme.typography.titleMedium)
            Text(feel, style = MaterialTheme.typography.bodyMedium)
        }
    }
}

internal val Touch.title
    get() = when (this) {
        Touch.LEFT -> R.string.touch_left
        Touch.RIGHT -> R.string.touch_right
        Touch.AHEAD -> R.string.touch_ahead
        Touch.TURN_AROUND -> R.string.touch_turn_around
        Touch.ARRIVED -> R.string.touch_arrived
        Touch.SOMETHING_AHEAD -> R.string.touch_something_ahead
        Touch.ROOM_ENTERED -> R.string.touch_room_entered
        Touch.UNSURE -> R.string.touch_unsure
        Touch.BELT_LOST -> R.string.touch_belt_lost
        Touch.BELT_BACK -> R.string.touch_belt_back
        Touch.MOVE_NOW -> R.string.touch_move_now
    }

private val Touch.feel
    get() = when (this) {
        Touch.LEFT -> R.string.feel_left
        Touch.RIGHT -> R.string.feel_right
        Touch.AHEAD -> R.string.feel_ahead
        Touch.TURN_AROUND -> R.string.feel_turn_around
        Touch.ARRIVED -> R.string.feel_arrived
        Touch.SOMETHING_AHEAD -> R.string.feel_something_ahead
        Touch.ROOM_ENTERED -> R.string.feel_room_entered
        Touch.UNSURE -> R.string.feel_unsure
        Touch.BELT_LOST -> R.string.feel_belt_lost
        Touch.BELT_BACK -> R.string.feel_belt_back
        Touch.MOVE_NOW -> R.string.feel_move_now
    }
