package org.echoway.core

import java.io.File

/** Ordinals as in the core. */
enum class Severity {
    WARNING,

    /** Nobody can be led with this. */
    UNUSABLE,
}

/** What sort of thing is wrong; ordinals as in the core, where each is explained (echoway/building/loader.hpp). */
enum class FindingKind {
    UNREADABLE, BAD_LINE, WRONG_COUNT, TOO_LARGE, NO_ROOMS, NO_CONFIG, OPEN_WALLS, UNKNOWN_ROOM, ROOM_ID, NAME,
    REPEATED, NO_LENGTH, OFF_FLOOR, WALL_END, CUT_OFF, CORNER_OR_EDGE, SIZE, FAR_ORIGIN, DOOR_POSITION, DOOR_LINES,
    DOOR_WIDTH, DOOR_LEVELS, LINK_LEVELS, DOOR_LOOP, UNREACHABLE, NO_PLACE, OVERLAP, MORE,
}

/**
 * Something to mend in a building's folder.
 *
 * @property line counted from 1; null when it concerns the whole file
 * @property problem what is wrong and what to do, exactly and in English
 */
data class Finding(val severity: Severity, val kind: FindingKind, val file: String, val line: Int?, val problem: String)

/** What the core finds when it looks a building's folder through; the unusable findings come first. */
data class BuildingCheck(val findings: List<Finding>) {
    val usable get() = findings.none { it.severity == Severity.UNUSABLE }

    companion object {
        private const val FIRST_GUESS_BYTES = 1 shl 14

        /** Reads all files of the folder: not for the main thread. */
        fun of(folder: File): BuildingCheck {
            val buffer = GrowingBuffer(FIRST_GUESS_BYTES).fill { out ->
                NativeCore.check(folder.path, out).also { check(it >= 0) { "The core failed ($it)." } }
            }
            return BuildingCheck(
                buffer.list { from ->
                    val severity = Severity.entries[from.getInt()]
                    val kind = FindingKind.entries[from.getInt()]
                    Finding(
                        severity,
                        kind,
                        line = from.getInt().takeIf { it > 0 },
                        file = from.text(),
                        problem = from.text(),
                    )
                },
            )
        }
    }
}
