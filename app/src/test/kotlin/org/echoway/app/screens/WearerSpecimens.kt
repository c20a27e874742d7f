package org.echoway.app.screens

import androidx.compose.ui.res.stringResource
import org.echoway.app.R
import org.echoway.app.control.Stillness
import org.echoway.app.ui.destinations.DestinationGroup
import org.echoway.app.ui.destinations.DestinationOption
import org.echoway.app.ui.destinations.DestinationsActions
import org.echoway.app.ui.destinations.DestinationsScreen
import org.echoway.app.ui.destinations.DestinationsUiState
import org.echoway.app.ui.firefighter.FirefighterActions
import org.echoway.app.ui.firefighter.FirefighterScreen
import org.echoway.app.ui.firefighter.FirefighterUiState
import org.echoway.app.ui.firstrun.FirstRunActions
import org.echoway.app.ui.firstrun.FirstRunScreen
import org.echoway.app.ui.firstrun.FirstRunStep
import org.echoway.app.ui.here.HereActions
import org.echoway.app.ui.here.HereScreen
import org.echoway.app.ui.here.HereUiState
import org.echoway.app.ui.practice.PracticeScreen
import org.echoway.core.Destination
import org.echoway.core.DestinationKind

/** The screens of voice, touch and controls. */
internal fun wearerSpecimens() = listOf(
    Specimen("destinations") {
        val groups = listOf(
            group(
                stringResource(R.string.places),
                DestinationKind.PLACE,
                "Front desk, in Room 1, Front office",
                "Lectern, in Room 4, Seminar room",
            ),
            group(
                stringResource(R.string.exits),
                DestinationKind.EXIT,
                "East stairs, in Room 7, Hall",
                "Main entrance, in Room 7, Hall",
            ),
        )
        DestinationsScreen(
            DestinationsUiState.Ready(
                stringResource(R.string.leading_to, "Lectern"), led = true, answered = false, groups,
            ),
            DestinationsActions({}, {}, {}),
        )
    },
    Specimen("destinations-off", LIGHT_ONLY) {
        DestinationsScreen(DestinationsUiState.Off, DestinationsActions({}, {}, {}))
    },
    Specimen("here") {
        val groups = listOf(
            group(
                stringResource(R.string.exits),
                DestinationKind.EXIT,
                "East stairs, in Room 7, Hall",
                "Main entrance, in Room 7, Hall",
            ),
            group(stringResource(R.string.rooms), DestinationKind.ROOM, "Room 1, Front office", "Room 2, Corridor"),
        )
        HereScreen(HereUiState.Ready(groups), HereActions({}, {}))
    },
    Specimen("here-off", LIGHT_ONLY) { HereScreen(HereUiState.Off, HereActions({}, {})) },
    Specimen("practice") { PracticeScreen(canVibrate = true, { _, _ -> }, {}) },
    Specimen("practice-no-vibrator", LIGHT_ONLY) { PracticeScreen(canVibrate = false, { _, _ -> }, {}) },
    firefighter(
        "firefighter",
        setOf(Variant.LIGHT, Variant.LARGE_TEXT, Variant.GERMAN_LARGE_TEXT, Variant.TABLET),
        running = true,
        Stillness.MOVING,
    ),
    firefighter("firefighter-alarm", setOf(Variant.LIGHT, Variant.GERMAN_LARGE_TEXT), running = true, Stillness.ALARM),
    firefighter("firefighter-off", LIGHT_ONLY, running = false, Stillness.MOVING),
    firefighter(
        "firefighter-no-voice",
        setOf(Variant.LIGHT, Variant.GERMAN_LARGE_TEXT),
        running = true,
        Stillness.MOVING,
        voiceMissing = true,
    ),
    firstRun("first-run-belt", USUAL, FirstRunStep.BELT),
    firstRun("first-run-front", LIGHT_ONLY, FirstRunStep.FRONT),
    firstRun("first-run-practice", setOf(Variant.LIGHT, Variant.GERMAN_LARGE_TEXT), FirstRunStep.PRACTICE),
)

private fun group(title: String, kind: DestinationKind, vararg names: String) =
    DestinationGroup(
        title,
        names.mapIndexed { i, name -> DestinationOption(Destination(kind, i), name, name.startsWith("Lectern")) },
    )

private fun firefighter(
    name: String,
    variants: Set<Variant>,
    running: Boolean,
    stillness: Stillness,
    voiceMissing: Boolean = false,
) = Specimen(name, variants) {
    val state = FirefighterUiState(
        whereOneIs(),
        if (running) inItsLanguage("Go straight, twenty feet.", "Geradeaus, sechs Meter.") else "",
        running,
        stillness,
        voiceMissing,
    )
    FirefighterScreen(state, FirefighterActions({}, {}, {}, {}))
}

private fun firstRun(name: String, variants: Set<Variant>, step: FirstRunStep) =
    Specimen(name, variants) { FirstRunScreen(step, FirstRunActions({}, {}, {}, {}, {})) }
