package org.echoway.app.guide

import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.launch
import org.echoway.app.Clock
import org.echoway.app.engine.NavigationState
import org.echoway.app.touch.Buzzer
import org.echoway.app.touch.Touch
import org.echoway.app.voice.Voice

/** Tells the wearer, by voice and by touch, what navigation finds out. Used from one thread. */
class Guide(private val wording: Wording, voice: Voice, private val buzzer: Buzzer, clock: Clock) {
    private val announcer = Announcer()
    private val queue = SpeechQueue(voice, clock)
    private val told = MutableStateFlow("")

    /** The newest line in words, for the screen and for phones that cannot speak. */
    val lastLine: StateFlow<String> = told.asStateFlow()

    /** Observes navigation until it is cancelled. */
    suspend fun run(states: Flow<NavigationState>) = coroutineScope {
        launch { queue.run() }
        if (!buzzer.present) tell(Message.NoVibration)
        states.collect { state -> announcer.onState(state).forEach(::tell) }
    }

    fun whereAmI() = tell(announcer.whereAmI())

    private fun tell(message: Message) {
        message.touch?.let(buzzer::play)
        val words = wording.words(message)
        told.value = words
        queue.say(words, message)
    }
}

/** What is felt along with the words. */
internal val Message.touch: Touch?
    get() = when (this) {
        is Message.RoomEntered -> Touch.ROOM_ENTERED
        is Message.DoorNear -> Touch.AHEAD.takeIf { seen.direction == Direction.AHEAD }
        Message.Unsure -> Touch.UNSURE
        is Message.FoundAgain -> Touch.ROOM_ENTERED
        Message.BeltLost -> Touch.BELT_LOST
        Message.BeltBack -> Touch.BELT_BACK
        else -> null
    }
