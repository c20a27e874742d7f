package org.echoway.app.testing

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.consumeAsFlow
import org.echoway.app.belt.BeltEvent
import org.echoway.app.belt.BeltSource

/** A belt whose events the test sends. */
class ScriptedBelt(override val bringsMotion: Boolean = true) : BeltSource {
    private val channel = Channel<BeltEvent>(Channel.UNLIMITED)
    override val events: Flow<BeltEvent> = channel.consumeAsFlow()

    var askedAgain = 0
        private set

    override fun askAgain() {
        askedAgain++
    }

    fun send(event: BeltEvent) {
        channel.trySend(event)
    }
}
