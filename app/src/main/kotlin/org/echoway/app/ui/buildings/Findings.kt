package org.echoway.app.ui.buildings

import androidx.compose.foundation.layout.Column
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.pluralStringResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.intl.LocaleList
import org.echoway.app.R
import org.echoway.core.Finding
import org.echoway.core.FindingKind
import org.echoway.core.Severity

/** What the core found, in the wearer's language; what a plan's author needs besides, the core says in English. */
@Composable
fun Findings(findings: List<Finding>) {
    if (findings.isEmpty()) Text(stringResource(R.string.nothing_to_mend))
    findings.take(SHOWN).forEach { Item(it) }
    val more = findings.size - SHOWN
    if (more > 0) Text(pluralStringResource(R.plurals.more_findings, more, more))
}

/** One stop for a screen reader, which reads the English part as English. */
@Composable
private fun Item(finding: Finding) {
    val severity = stringResource(
        if (finding.severity == Severity.UNUSABLE) R.string.finding_unusable else R.string.finding_warning,
    )
    val place = finding.line?.let { stringResource(R.string.finding_line, finding.file, it) } ?: finding.file
    val detail = stringResource(R.string.finding_detail, finding.problem)
    Column(Modifier.semantics(mergeDescendants = true) {}) {
        Text(
            stringResource(R.string.finding, severity, stringResource(finding.kind.words), place),
            style = MaterialTheme.typography.bodyLarge,
        )
        Text(
            buildAnnotatedString {
                append(detail)
                addStyle(
                    SpanStyle(localeList = LocaleList("en")), detail.length - finding.problem.length, detail.length,
                )
            },
            style = MaterialTheme.typography.bodyMedium,
        )
    }
}

/** A building with many faults mostly has one, many times. */
private const val SHOWN = 20

private val FindingKind.words
    get() = when (this) {
        FindingKind.UNREADABLE -> R.string.kind_unreadable
        FindingKind.BAD_LINE -> R.string.kind_bad_line
        FindingKind.WRONG_COUNT -> R.string.kind_wrong_count
        FindingKind.TOO_LARGE -> R.string.kind_too_large
        FindingKind.NO_ROOMS -> R.string.kind_no_rooms
        FindingKind.NO_CONFIG -> R.string.kind_no_config
        FindingKind.OPEN_WALLS -> R.string.kind_open_walls
        FindingKind.UNKNOWN_ROOM -> R.string.kind_unknown_room
        FindingKind.ROOM_ID -> R.string.kind_room_id
        FindingKind.NAME -> R.string.kind_name
        FindingKind.REPEATED -> R.string.kind_repeated
        FindingKind.NO_LENGTH -> R.string.kind_no_length
        FindingKind.OFF_FLOOR -> R.string.kind_off_floor
        FindingKind.WALL_END -> R.string.kind_wall_end
        FindingKind.CUT_OFF -> R.string.kind_cut_off
        FindingKind.CORNER_OR_EDGE -> R.string.kind_corner_or_edge
        FindingKind.SIZE -> R.string.kind_size
        FindingKind.FAR_ORIGIN -> R.string.kind_far_origin
        FindingKind.DOOR_POSITION -> R.string.kind_door_position
        FindingKind.DOOR_LINES -> R.string.kind_door_lines
        FindingKind.DOOR_WIDTH -> R.string.kind_door_width
        FindingKind.DOOR_LEVELS -> R.string.kind_door_levels
        FindingKind.LINK_LEVELS -> R.string.kind_link_levels
        FindingKind.DOOR_LOOP -> R.string.kind_door_loop
        FindingKind.UNREACHABLE -> R.string.kind_unreachable
        FindingKind.NO_PLACE -> R.string.kind_no_place
        FindingKind.OVERLAP -> R.string.kind_overlap
        FindingKind.MORE -> R.string.kind_more
    }
