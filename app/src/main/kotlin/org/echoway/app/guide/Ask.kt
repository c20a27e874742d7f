package org.echoway.app.guide

/**
 * What a wearer can ask for without looking: by button, key, notification, tile or headset (docs/voice-and-touch.md).
 */
enum class Ask {
    WHERE_AM_I,

    /** What was said last, or the last instruction again. */
    REPEAT,

    /** Hold back everything but danger, loss and answers, or speak again. */
    MUTE,

    /** To the nearest exit. */
    WAY_OUT,

    /** Back the way one came. */
    WAY_BACK,

    STOP_LEADING,

    /** The wearer is back at the entrance that was chosen, or lost if none was: look for them anew from there. */
    START_AGAIN,
}

/** Whoever answers. Safe from any thread. */
fun interface Asking {
    fun ask(ask: Ask)
}
