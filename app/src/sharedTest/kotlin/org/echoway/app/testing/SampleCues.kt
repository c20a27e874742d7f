package org.echoway.app.testing

import org.echoway.app.engine.Core
import org.echoway.app.engine.GuidanceEvent
import org.echoway.app.engine.Wish
import org.echoway.core.Cue
import org.echoway.core.CueKind
import org.echoway.core.CueLandmark
import org.echoway.core.CueTail
import org.echoway.core.LandmarkKind
import org.echoway.core.Plan
import org.echoway.core.SpeechStyle
import org.echoway.core.Urgency

/** Cues as the core gives them out. */
object SampleCues {
    fun cue(
        kind: CueKind,
        words: String,
        degrees: Double? = null,
        urgency: Urgency = urgencyOf(kind),
        room: Int = Plan.NO_ROOM,
        tail: CueTail? = null,
    ) = Cue(
        timeS = 0.0, kind = kind, urgency = urgency, direction = degrees?.let(Math::toRadians),
        distanceM = null, sigmaM = 0.1, timeToLiveS = 2.0, up = false, count = 0,
        room = room, landmark = CueLandmark(LandmarkKind.NONE, -1), tail = tail, words = words,
    )

    fun told(kind: CueKind, words: String, degrees: Double? = null) = GuidanceEvent.Told(cue(kind, words, degrees))

    private fun urgencyOf(kind: CueKind) = when (kind) {
        CueKind.STOP, CueKind.OBSTACLE -> Urgency.DANGER
        in CueKind.UNCERTAIN..CueKind.SENSOR_BLOCKED -> Urgency.BROKEN
        in CueKind.WRONG_WAY..CueKind.TAKE_LINK -> Urgency.TURN
        in CueKind.ROOM_HERE..CueKind.DESTINATION -> Urgency.ASKED
        else -> Urgency.PLACE
    }
}

/** A core that only remembers what was asked of it. */
class RecordingCore : Core {
    val wishes = mutableListOf<Wish>()
    var style: SpeechStyle? = null

    override fun ask(wish: Wish) {
        wishes += wish
    }

    override fun speakIn(style: SpeechStyle) {
        this.style = style
    }
}
