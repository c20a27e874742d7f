package org.echoway.app.testing

import org.echoway.app.touch.Buzzer
import org.echoway.app.touch.Touch

/** Remembers what was felt. */
class RecordingBuzzer(override val present: Boolean = true) : Buzzer {
    val felt = mutableListOf<Touch>()

    override fun play(touch: Touch) {
        felt += touch
    }
}
