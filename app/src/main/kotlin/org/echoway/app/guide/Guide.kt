package org.echoway.app.guide

import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.launch
import org.echoway.app.Clock
import org.echoway.app.building.entrance
import org.echoway.app.building.startAt
import org.echoway.app.engine.Core
import org.echoway.app.engine.GuidanceEvent
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.Wish
import org.echoway.app.settings.Settings
import org.echoway.app.touch.Buzzer
import org.echoway.app.touch.GAP_MS
import org.echoway.app.touch.Touch
import org.echoway.app.touch.durationMs
import org.echoway.app.touch.tickGapMs
import org.echoway.core.Destination
import org.echoway.core.Language
import org.echoway.core.RoutePreferences
import org.echoway.core.SpeechStyle

/**
 * Tells the wearer, by voice and by touch, what navigation finds out, and answers what they ask. Used from one thread.
 *
 * @param wordings the words of each language
 */
class Guide(
    private val wordings: (Language) -> Wording,
    private val speech: SpeechQueue,
    private val buzzer: Buzzer,
    private val core: Core,
    private val clock: Clock,
) : Asking {
    private val announcer = Announcer()
    private val told = MutableStateFlow("")
    private val silenced = MutableStateFlow(false)
    private var manner = Manner()
    private var preferences = RoutePreferences()
    private var entrance: String? = null
    private var wording = wordings(speech.language.value)
    private var vibrates = true
    private var wordUntilS = Double.NEGATIVE_INFINITY
    private var running = false

    /** The newest line in words, for the screen and for phones that cannot speak. */
    val lastLine: StateFlow<String> = told.asStateFlow()

    val muted: StateFlow<Boolean> = silenced.asStateFlow()

    /** Observes navigation until it is cancelled, first of all as the settings are now; [follow] keeps to them. */
    suspend fun run(
        states: Flow<NavigationState>,
        events: Flow<GuidanceEvent>,
        settings: Flow<Settings>,
    ) = coroutineScope {
        silenced.value = false
        adopt(settings.first(), speech.language.value)
        if (!buzzer.present && vibrates) tell(Message.NoVibration)
        launch { events.collect { event -> announcer.onEvent(event).forEach(::answer) } }
        launch { states.map(::obstacle).distinctUntilChanged().collectLatest { it?.let { tick(it) } } }
        try {
            states.collect(::onState)
        } finally {
            // Whoever asks later must not be answered as if guidance went on.
            onState(NavigationState.Idle)
        }
    }

    private fun onState(state: NavigationState) {
        running = state is NavigationState.Running
        announcer.onState(state).forEach(::tell)
    }

    override fun ask(ask: Ask) {
        when (ask) {
            Ask.WHERE_AM_I -> announcer.withoutAnswer()?.let(::excuse) ?: core.ask(Wish.WhereAmI)
            Ask.REPEAT -> repeat()
            Ask.MUTE -> mute(!silenced.value)
            Ask.WAY_OUT -> leadTo(Destination.WAY_OUT)
            Ask.WAY_BACK -> lead(Wish.BackTrack)
            Ask.STOP_LEADING -> lead(Wish.StopLeading)
            Ask.START_AGAIN -> standAt(announcer.plan?.entrance(entrance))
        }
    }

    /** The wearer says that they stand at this exit or in this room, or that they do not know where (null). */
    fun standAt(place: Destination?) {
        val plan = announcer.plan
        if (plan == null) {
            tell(Message.CannotLead(NoWay.NOT_RUNNING))
        } else {
            lead(Wish.StandAt(startAt(plan, place), place))
        }
    }

    /** Leads to a destination from now on. */
    fun leadTo(destination: Destination) {
        // The core keeps the wish and answers it when it knows where the wearer is; without a belt that may take long.
        if (lead(Wish.LeadTo(destination, preferences))) announcer.withoutAnswer()?.let(::excuse)
    }

    /** Says why there is no answer now. */
    private fun excuse(why: NoAnswer) = answer(Message.Unanswerable(why))

    /** Says it; where there is no answer now, does what may help. */
    private fun answer(message: Message) {
        if (message == Message.Unanswerable(NoAnswer.NotAllowed)) core.ask(Wish.AllowBelt)
        tell(message)
    }

    /** Says a line of a screen that explains itself; the newest takes the place of the one before. */
    fun explain(words: String) {
        hush()
        tell(Message.Explanation(words))
    }

    /** Ends an explanation half way through: the wearer has gone on. */
    fun hush() = speech.hush(Message.EXPLANATION)

    /** Lets one feel a pattern and says what it is called. */
    fun practise(touch: Touch, words: String) {
        buzzer.play(touch)
        explain(words)
    }

    private fun lead(wish: Wish): Boolean {
        if (running) core.ask(wish) else tell(Message.CannotLead(NoWay.NOT_RUNNING))
        return running
    }

    /** What was just said, as it was; an instruction only while it still holds, and that the core knows. */
    private fun repeat() {
        val last = speech.lastSpoken?.takeIf { it.message !is Message.Told || it.message.rank > Rank.TURN }
        when {
            last != null -> tell(Message.Again(last.words))
            running && announcer.withoutAnswer() == null -> core.ask(Wish.Repeat)
            else -> tell(Message.NothingToRepeat)
        }
    }

    private fun mute(on: Boolean) {
        silenced.value = on
        manner = manner.copy(muted = on)
        tell(Message.Muted(on))
    }

    /** Speaks as the wearer wants, until it is cancelled; while guidance is off too, for what screens explain. */
    suspend fun follow(settings: Flow<Settings>) =
        combine(settings, speech.language, ::Pair).collect { (wanted, language) -> adopt(wanted, language) }

    private fun adopt(settings: Settings, language: Language) {
        speech.speakIn(settings.language)
        vibrates = settings.vibration
        wording = wordings(language)
        manner = Manner(settings.service, settings.verbosity, silenced.value)
        preferences = settings.routePreferences
        entrance = settings.entrance
        core.speakIn(SpeechStyle(language, settings.directions, settings.lengths))
    }

    /** Tells what is not navigation's: of the app, and of the wearer. */
    fun tell(message: Message) {
        message.touch?.let(::feel)
        if (!manner.speaks(message)) return
        val words = wording.words(message)
        told.value = words
        speech.say(words, message)
    }

    /** One motor: ticks make way until the word is over. */
    private fun feel(touch: Touch) {
        if (!vibrates) return
        buzzer.play(touch)
        wordUntilS = clock.nowS() + (touch.durationMs + GAP_MS) / 1000.0
    }

    /** Ticks that quicken as the thing in the way comes nearer. */
    private suspend fun tick(distanceM: Double) {
        while (true) {
            if (vibrates && clock.nowS() >= wordUntilS) buzzer.play(Touch.SOMETHING_AHEAD)
            delay(tickGapMs(distanceM))
        }
    }

    private fun obstacle(state: NavigationState): Double? =
        (state as? NavigationState.Running)
            ?.takeIf { it.hearsBelt }
            ?.obstacleM?.let { (it / TICK_GRAIN_M).toInt() * TICK_GRAIN_M }

    private companion object {
        /** Ticks change their pace in steps of this; an estimate's trembling is not felt. */
        const val TICK_GRAIN_M = 0.1
    }
}
