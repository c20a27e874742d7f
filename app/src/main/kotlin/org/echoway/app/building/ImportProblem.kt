package org.echoway.app.building

/** Why something that was picked is not a building that can be kept. Nothing of it is kept. */
enum class ImportProblem {
    /** Not a zip archive, or cut short. */
    UNREADABLE,

    /** A name leads out of the building's folder, is absolute, or is a link. */
    UNSAFE_NAME,

    /** A name is not text in UTF-8. */
    BAD_NAME,

    /** Two files have the same name. */
    DUPLICATE_NAME,

    /** More files than any building has. */
    TOO_MANY_FILES,

    /** More bytes, unpacked, than any building has. */
    TOO_LARGE,

    /** An archive with a password. */
    ENCRYPTED,

    /** No building.cfg, or more than one. */
    NO_BUILDING,
    SEVERAL_BUILDINGS,

    /** The phone has no room for it. */
    DISK_FULL,
}

/** @property detail a file's name or the system's own words; may be empty */
class ImportException(val problem: ImportProblem, val detail: String = "", cause: Throwable? = null) :
    Exception("$problem $detail", cause)
