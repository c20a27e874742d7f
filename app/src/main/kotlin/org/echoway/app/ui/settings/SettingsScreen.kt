package org.echoway.app.ui.settings

import androidx.annotation.StringRes
import androidx.compose.runtime.Composable
import androidx.compose.ui.platform.LocalResources
import androidx.compose.ui.res.stringResource
import org.echoway.app.R
import org.echoway.app.settings.ServiceModel
import org.echoway.app.settings.Settings
import org.echoway.app.settings.ThemeChoice
import org.echoway.app.settings.Verbosity
import org.echoway.app.ui.common.Choice
import org.echoway.app.ui.common.Choices
import org.echoway.app.ui.common.Screen
import org.echoway.app.ui.common.Toggle
import org.echoway.core.DirectionStyle
import org.echoway.core.Language
import org.echoway.core.LengthStyle

/** Everything that the wearer can choose about how the app speaks, looks and feels. Each choice holds at once. */
@Composable
fun SettingsScreen(settings: Settings, onChange: ((Settings) -> Settings) -> Unit, onBack: () -> Unit) {
    Screen(stringResource(R.string.settings), onBack) {
        OneOf(
            R.string.setting_language, listOf(null) + Language.entries, settings.language, Language?::title,
        ) { choice -> onChange { it.copy(language = choice) } }
        OneOf(R.string.setting_service, ServiceModel.entries, settings.service, ServiceModel::title) { choice ->
            onChange { it.copy(service = choice) }
        }
        OneOf(R.string.setting_verbosity, Verbosity.entries, settings.verbosity, Verbosity::title) { choice ->
            onChange { it.copy(verbosity = choice) }
        }
        OneOf(
            R.string.setting_directions, DirectionStyle.entries, settings.directions, DirectionStyle::title,
        ) { choice -> onChange { it.copy(directions = choice) } }
        OneOf(R.string.setting_lengths, LengthStyle.entries, settings.lengths, LengthStyle::title) { choice ->
            onChange { it.copy(lengths = choice) }
        }
        Toggle(stringResource(R.string.setting_avoid_stairs), settings.avoidStairs) { on ->
            onChange { it.copy(avoidStairs = on) }
        }
        OneOf(R.string.setting_theme, ThemeChoice.entries, settings.theme, ThemeChoice::title) { choice ->
            onChange { it.copy(theme = choice) }
        }
        Toggle(stringResource(R.string.setting_vibration), settings.vibration) { on ->
            onChange { it.copy(vibration = on) }
        }
        Toggle(stringResource(R.string.setting_motion), settings.motion) { on -> onChange { it.copy(motion = on) } }
        Toggle(stringResource(R.string.setting_volume_keys), settings.volumeKeys) { on ->
            onChange { it.copy(volumeKeys = on) }
        }
        Toggle(stringResource(R.string.setting_record), settings.record) { on -> onChange { it.copy(record = on) } }
        Choices(stringResource(R.string.setting_not_moved)) {
            ALERT_CHOICES_S.forEach { seconds ->
                Choice(alertTitle(seconds), seconds == settings.notMovedAlertS) {
                    onChange { it.copy(notMovedAlertS = seconds) }
                }
            }
        }
    }
}

@Composable
private fun <T> OneOf(@StringRes title: Int, all: List<T>, chosen: T, name: (T) -> Int, onChoose: (T) -> Unit) {
    Choices(stringResource(title)) {
        all.forEach { each -> Choice(stringResource(name(each)), each == chosen) { onChoose(each) } }
    }
}

@Composable
private fun alertTitle(seconds: Int) =
    if (seconds == 0) {
        stringResource(R.string.never)
    } else {
        LocalResources.current.getQuantityString(R.plurals.seconds, seconds, seconds)
    }

/** 0 is never. */
private val ALERT_CHOICES_S = listOf(0, 20, Settings.DEFAULT_ALERT_S, 60, 120)

private val Language?.title
    get() = when (this) {
        null -> R.string.language_system
        Language.ENGLISH -> R.string.language_english
        Language.GERMAN -> R.string.language_german
        Language.FRENCH -> R.string.language_french
    }

private val ServiceModel.title
    get() = when (this) {
        ServiceModel.CONTINUOUS -> R.string.service_continuous
        ServiceModel.ON_REQUEST -> R.string.service_on_request
    }

private val Verbosity.title
    get() = when (this) {
        Verbosity.BRIEF -> R.string.verbosity_brief
        Verbosity.NORMAL -> R.string.verbosity_normal
        Verbosity.FULL -> R.string.verbosity_full
    }

private val DirectionStyle.title
    get() = when (this) {
        DirectionStyle.SIDES -> R.string.directions_sides
        DirectionStyle.CLOCK -> R.string.directions_clock
        DirectionStyle.DEGREES -> R.string.directions_degrees
    }

private val LengthStyle.title
    get() = when (this) {
        LengthStyle.FEET -> R.string.lengths_feet
        LengthStyle.METRES -> R.string.lengths_metres
        LengthStyle.STEPS -> R.string.lengths_steps
    }

private val ThemeChoice.title
    get() = when (this) {
        ThemeChoice.SYSTEM -> R.string.theme_system
        ThemeChoice.LIGHT -> R.string.theme_light
        ThemeChoice.DARK -> R.string.theme_dark
        ThemeChoice.HIGH_CONTRAST -> R.string.theme_high_contrast
        ThemeChoice.SMOKE -> R.string.theme_smoke
    }
