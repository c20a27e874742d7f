package org.echoway.app.belt

import java.io.IOException
import kotlinx.coroutines.flow.Flow
import org.echoway.core.BeltSetup
import org.echoway.core.MotionHint

/** What a belt source tells. Whoever hears it cannot tell which source it comes from. */
sealed interface BeltEvent {
    /** The line is open; bytes may follow. */
    data object Attached : BeltEvent

    /** Bytes as the belt sent them, cut anywhere; [arrivalS] is when the last of them arrived. */
    class Bytes(val data: ByteArray, val arrivalS: Double) : BeltEvent

    /** A motion hint that was recorded with the walk. */
    data class Motion(val hint: MotionHint) : BeltEvent

    /** Where the wearer said, in a recording, that they stand. */
    data class Restart(val restart: LoggedRestart) : BeltEvent

    /** The line is gone; the source waits for it to come back. */
    data object Detached : BeltEvent

    /** A belt is there but the wearer has not allowed its use; the phone asks them. */
    data object PermissionMissing : BeltEvent

    /** They said no, or let the question go by; [BeltSource.askAgain] puts it once more. */
    data object PermissionRefused : BeltEvent

    /** Nothing more will come: a recording is over. */
    data object Ended : BeltEvent
}

/** A belt: on the USB port, in a recorded log, or in a simulated walk. */
interface BeltSource {
    /** Cold: collecting opens the line, and cancelling closes it. */
    val events: Flow<BeltEvent>

    /**
     * What belt it is.
     *
     * @throws IOException when a recording cannot be read
     */
    suspend fun setup(): BeltSetup = BeltSetup()

    /** Asks the wearer once more for what they refused; nothing where nothing was. Safe from any thread. */
    fun askAgain() = Unit

    /** Whether [events] brings motion hints of its own, so that the phone's sensors must stay out. */
    val bringsMotion: Boolean
}
