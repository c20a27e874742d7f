package org.echoway.app.settings

import org.echoway.core.DirectionStyle
import org.echoway.core.Language
import org.echoway.core.LengthStyle
import org.echoway.core.RoutePreferences

/** Where echoes come from. */
enum class SourceKind { USB, SIMULATED_WALK, RECORDING }

/** Whether guidance speaks by itself (the thesis's two service models). */
enum class ServiceModel {
    CONTINUOUS,

    /** Only when asked. Danger, loss and anything broken are told all the same. */
    ON_REQUEST,
}

/** How much is said. */
enum class Verbosity {
    /** Danger, loss, turns and answers. */
    BRIEF,

    /** Besides: rooms, doors and places on the way. */
    NORMAL,

    /** Besides: what is nice to know. */
    FULL,
}

/** The screen's colours. */
enum class ThemeChoice {
    /** Light or dark, as the phone's other screens are. */
    SYSTEM,
    LIGHT,
    DARK,
    HIGH_CONTRAST,

    /** Amber on black: little light of one's own thrown back by smoke. */
    SMOKE,
}

/**
 * What the wearer chose.
 *
 * @property building id of the floor plan; null until one was chosen
 * @property entrance name of the way in; null when the wearer does not know it
 * @property recording file name of the log to replay, for [SourceKind.RECORDING]
 * @property navigating whether guidance was on when the app was last alive, so that it goes on after its death
 * @property walkedS when the belt was last heard while guidance was on, on the app's clock; to the minute, null before
 * the first time
 * @property goal where the wearer was led when the app was last alive; null nowhere, or back the way they came
 * @property avoidStairs take stairs only when nothing else leads there
 * @property firefighter show the one large screen, and watch for a wearer who does not move
 * @property notMovedAlertS seconds without a movement until the firefighter screen's alert; 0 for never
 * @property language of voice and screen; null for the phone's own
 * @property vibration whether guidance is felt as well as heard
 * @property motion whether the phone's own sensors help to locate
 * @property volumeKeys whether the volume keys ask and repeat while the app is shown
 * @property record whether walks are recorded
 * @property introduced the first run's steps were heard or skipped
 */
data class Settings(
    val building: String? = null,
    val entrance: String? = null,
    val source: SourceKind = SourceKind.USB,
    val recording: String? = null,
    val navigating: Boolean = false,
    val walkedS: Double? = null,
    val goal: Goal? = null,
    val service: ServiceModel = ServiceModel.CONTINUOUS,
    val verbosity: Verbosity = Verbosity.NORMAL,
    val directions: DirectionStyle = DirectionStyle.SIDES,
    val lengths: LengthStyle = LengthStyle.FEET,
    val avoidStairs: Boolean = false,
    val firefighter: Boolean = false,
    val notMovedAlertS: Int = DEFAULT_ALERT_S,
    val language: Language? = null,
    val theme: ThemeChoice = ThemeChoice.SYSTEM,
    val vibration: Boolean = true,
    val motion: Boolean = true,
    val volumeKeys: Boolean = true,
    val record: Boolean = false,
    val introduced: Boolean = false,
) {
    val routePreferences get() = RoutePreferences(avoidStairs)

    companion object {
        /** What firefighters' own motion alarms wait for. */
        const val DEFAULT_ALERT_S = 30
    }
}
