package org.echoway.app.screens

import java.time.LocalDateTime
import org.echoway.app.building.ImportProblem
import org.echoway.app.recording.Recording
import org.echoway.app.recording.RecordingStatus
import org.echoway.app.ui.belt.BeltScreen
import org.echoway.app.ui.buildings.BuildingItem
import org.echoway.app.ui.buildings.BuildingNotice
import org.echoway.app.ui.buildings.BuildingsActions
import org.echoway.app.ui.buildings.BuildingsScreen
import org.echoway.app.ui.buildings.BuildingsUiState
import org.echoway.app.ui.diagnostics.DiagnosticsScreen
import org.echoway.app.ui.recordings.RecordingsActions
import org.echoway.app.ui.recordings.RecordingsScreen
import org.echoway.app.ui.recordings.RecordingsUiState
import org.echoway.core.BeltHealth
import org.echoway.core.BeltLink
import org.echoway.core.Element
import org.echoway.core.ExplainedEcho
import org.echoway.core.Finding
import org.echoway.core.FindingKind
import org.echoway.core.LengthStyle
import org.echoway.core.Point
import org.echoway.core.SensorHealth
import org.echoway.core.SensorState
import org.echoway.core.Severity
import org.echoway.core.Spot

/** Buildings, recordings, diagnostics, belt. */
internal fun dataSpecimens() = listOf(
    buildings("buildings", USUAL, null),
    buildings("buildings-imported", LIGHT_ONLY, BuildingNotice.Imported("Two rooms", FINDINGS)),
    buildings("buildings-refused", LIGHT_ONLY, BuildingNotice.Refused(ImportProblem.UNSAFE_NAME, "../../treasure")),
    buildings(
        "buildings-unusable",
        setOf(Variant.LIGHT, Variant.GERMAN_LARGE_TEXT),
        BuildingNotice.Unusable(FINDINGS.map { it.copy(severity = Severity.UNUSABLE) }),
    ),
    buildings("buildings-delete", setOf(Variant.LIGHT, Variant.GERMAN_LARGE_TEXT), null, askDelete = MINE),
    recordings("recordings", USUAL, RecordingStatus.On("2026-11-25_20-15-03")),
    recordings("recordings-delete", LIGHT_ONLY, RecordingStatus.Off, askDelete = RECORDED.last()),
    recordings("recordings-disk-full", LIGHT_ONLY, RecordingStatus.Failed(diskFull = true, reason = "")),
    Specimen("diagnostics") { DiagnosticsScreen(HEALTH, {}, {}) },
    Specimen("diagnostics-no-belt", LIGHT_ONLY) { DiagnosticsScreen(BeltHealth.NONE, {}, {}) },
    Specimen("belt-view") { BeltScreen(SCAN, LengthStyle.FEET, {}) },
    Specimen("belt-view-off", LIGHT_ONLY) { BeltScreen(emptyList(), LengthStyle.FEET, {}) },
)

private fun buildings(
    name: String,
    variants: Set<Variant>,
    notice: BuildingNotice?,
    askDelete: BuildingItem? = null,
) = Specimen(name, variants) {
    BuildingsScreen(
        BuildingsUiState(
            listOf(
                BuildingItem(
                    "torgersen-lab", "Torgersen laboratory", rooms = 7, exits = 2, imported = false, chosen = true,
                ),
                MINE,
            ),
            notice,
            askDelete,
        ),
        BuildingsActions({}, {}, {}, {}, {}, {}, {}, {}),
    )
}

private val MINE = BuildingItem("two-rooms", "Two rooms", rooms = 2, exits = 0, imported = true, chosen = false)

private fun recordings(
    name: String,
    variants: Set<Variant>,
    status: RecordingStatus,
    askDelete: Recording? = null,
) = Specimen(name, variants) {
    RecordingsScreen(
        RecordingsUiState(RECORDED, recordWalks = true, status, askDelete), RecordingsActions({}, {}, {}, {}, {}, {}),
    )
}

private val RECORDED = listOf(
    Recording("2026-11-25_20-15-03", LocalDateTime.of(2026, 11, 25, 20, 15, 3), 42.0, 61_234, "torgersen-lab"),
    Recording("2026-11-24_09-03-00", LocalDateTime.of(2026, 11, 24, 9, 3, 0), 1260.0, 1_812_345, "torgersen-lab"),
)

private val FINDINGS = listOf(
    Finding(
        Severity.WARNING,
        FindingKind.DOOR_POSITION,
        "building.cfg",
        7,
        "the door between office and hall is 4 in off the wall; move it onto the wall",
    ),
    Finding(
        Severity.WARNING,
        FindingKind.UNREACHABLE,
        "room-hall.room",
        null,
        "no door leads here; add one to building.cfg",
    ),
)

private val HEALTH = BeltHealth(
    link = BeltLink.CONNECTED, firingsPerSecond = 16.0, goodSentences = 12_345, badChecksums = 3, malformed = 1,
    lostFirings = 12,
    restarts = 0, temperatureC = 21.5, batteryV = 7.38, firmware = "1.4",
    sensors = List(15) { i ->
        val state = when (i) {
            1 -> SensorState.SILENT
            9 -> SensorState.FAULT
            else -> SensorState.GOOD
        }
        SensorHealth(
            state,
            firings = 64,
            echoes = if (i == 1) 0 else 60 - i,
            faultCode = if (i == 9) 2 else 0,
            lastRangeM = 1.0,
            lastTimeS = 1.0,
        )
    },
)

private val SCAN = List(15) { i ->
    val element = listOf(
        Element.WALL, Element.CORNER, Element.WALL, Element.EDGE, Element.WALL, Element.NONE, Element.REFLECTOR,
    )[i % 7]
    val range = if (i == 4 || i == 11) null else 1.2 + 0.35 * ((i * 5) % 9)
    val known = range != null && element != Element.NONE
    ExplainedEcho(
        1.0,
        range,
        if (known) element else Element.NONE,
        Spot(0, Point(1.0, 1.0)).takeIf { known },
        range.takeIf { known },
    )
}
