package org.echoway.app.ui

import kotlinx.serialization.Serializable

/** The app's screens, as destinations of its navigation. */
sealed interface Route {
    @Serializable data object Live : Route

    @Serializable data object Menu : Route

    @Serializable data object Setup : Route

    @Serializable data object Settings : Route

    @Serializable data object Destinations : Route

    @Serializable data object Here : Route

    @Serializable data object Practice : Route

    @Serializable data object Firefighter : Route

    @Serializable data object FirstRun : Route

    @Serializable data object Buildings : Route

    @Serializable data object Recordings : Route

    @Serializable data object Diagnostics : Route

    @Serializable data object BeltView : Route
}
