package org.echoway.app.testing

import org.echoway.app.control.Siren

/** Remembers what was sounded. */
class RecordingSiren : Siren {
    var warnings = 0
    var sounding = false

    override fun warn() {
        warnings++
    }

    override fun sound(on: Boolean) {
        sounding = on
    }
}
