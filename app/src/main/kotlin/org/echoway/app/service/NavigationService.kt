package org.echoway.app.service

import android.app.ForegroundServiceStartNotAllowedException
import android.app.Notification
import android.content.Context
import android.content.Intent
import android.content.pm.ServiceInfo
import android.os.Build
import android.os.PowerManager
import androidx.core.app.ServiceCompat
import androidx.core.content.ContextCompat
import androidx.lifecycle.LifecycleService
import androidx.lifecycle.lifecycleScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.filter
import kotlinx.coroutines.flow.filterIsInstance
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import org.echoway.app.building.startAt
import org.echoway.app.container
import org.echoway.app.control.MediaControls
import org.echoway.app.engine.NavigationState
import org.echoway.app.engine.NoStart
import org.echoway.app.engine.Wish
import org.echoway.app.guide.Ask
import org.echoway.app.guide.Message
import org.echoway.app.guide.hearsBelt
import org.echoway.app.recording.RecordingStatus
import org.echoway.app.recording.RecordingSwitch
import org.echoway.app.settings.Goal
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.core.Start

/**
 * Keeps navigation alive with the screen off. Thin: it starts and stops the parts, shows the notification and holds the
 * wake lock; what is said and found is theirs.
 */
class NavigationService : LifecycleService() {
    private lateinit var notification: NavigationNotification
    private lateinit var wakeLock: IdleWakeLock
    private var navigation: Job? = null
    private val takingOver = Mutex()

    override fun onCreate() {
        super.onCreate()
        notification = NavigationNotification(this)
        val lock =
            getSystemService(PowerManager::class.java).newWakeLock(PowerManager.PARTIAL_WAKE_LOCK, "echoway:navigation")
        wakeLock = IdleWakeLock(lock, container.clock)
    }

    override fun onStartCommand(intent: Intent?, flags: Int, startId: Int): Int {
        super.onStartCommand(intent, flags, startId)
        when (intent?.action) {
            ACTION_STOP -> stopNavigation()
            in ASKS -> container.guide.ask(ASKS.getValue(intent?.action.orEmpty()))
            // Without an intent the system brings the service back after it had killed the app.
            else -> lifecycleScope.launch { startNavigation(restored = intent == null) }
        }
        return START_STICKY
    }

    private suspend fun startNavigation(restored: Boolean) {
        val settings = container.settings.settings.first()
        if (restored && !settings.navigating) {
            stopSelf()
            return
        }
        notification = NavigationNotification(this, settings.language)
        if (!enterForeground(settings.source)) {
            // Silence would go on meaning that all is well.
            container.guide.tell(Message.Stopped)
            stopSelf()
            return
        }
        container.settings.update { it.copy(navigating = true) }
        // A walk that was under way a moment ago goes on for who begins by hand as well, where Android did not.
        val interrupted = restored || navigation == null && settings.navigating && walkedJustNow(settings)
        // Two at once would share the core and the buttons. Who begins meanwhile takes over from the one that
        // has just begun.
        takingOver.withLock {
            navigation?.cancelAndJoin()
            navigation = lifecycleScope.launch { navigate(settings, interrupted) }
        }
    }

    private fun walkedJustNow(settings: Settings) =
        settings.walkedS?.let { container.clock.nowS() - it in 0.0..JUST_NOW_S } == true

    /** [interrupted]: guidance was under way, and who wears a belt may have left the entrance since. */
    private suspend fun navigate(settings: Settings, interrupted: Boolean) = coroutineScope {
        val states = container.navigator.state
        launch { container.guide.run(states, container.navigator.events, container.settings.settings) }
        launch { container.lookout.run(states, container.settings.settings) }
        launch { buttons() }
        launch { notify(states) }
        launch { states.collect { wakeLock.update(it is NavigationState.Running && it.hearsBelt) } }
        val building = settings.building?.let { container.buildings.find(it) }
        if (building == null) {
            notification.show(notification.noBuilding)
            container.guide.tell(Message.CannotStart(NoStart.NO_BUILDING))
            return@coroutineScope
        }
        // A walk that is replayed begins anew, where it began.
        val walkedOn = interrupted && settings.source == SourceKind.USB
        val goal = settings.goal?.takeIf { walkedOn }?.within(building.id, building.plan)
        if (walkedOn) container.guide.tell(Message.Interrupted(building.plan, goal))
        val start = if (walkedOn) Start() else startAt(building.plan, settings.entrance)
        val recording = RecordingSwitch(container.recordings, building)
        // A walk that is replayed is not recorded again.
        if (settings.source != SourceKind.RECORDING) {
            launch { recording.follow(container.settings.settings.map { it.record }) }
        }
        launch { container.recordings.status.collect(::tellOfRecording) }
        launch { keepGoal(states) }
        if (settings.source == SourceKind.USB) launch { keepTime(states) }
        val wish = goal?.let { Wish.LeadTo(it, settings.routePreferences) }
        container.navigator.run(building, start, container.beltSource(settings), container.motion, recording, wish)
    }

    /** Writes down where the wearer is led, so that the way goes on after the app's death. */
    private suspend fun keepGoal(states: Flow<NavigationState>) = states.filterIsInstance<NavigationState.Running>()
        .map { state -> state.destination?.let { Goal(state.building.id, it) } }
        .distinctUntilChanged()
        .collect { goal -> container.settings.update { it.copy(goal = goal) } }

    /** Writes down when the wearer walked with the belt. */
    private suspend fun keepTime(states: Flow<NavigationState>) = states.filterIsInstance<NavigationState.Running>()
        .filter { it.hearsBelt }
        .map { it.timeS }
        .distinctUntilChanged { noted, now -> now - noted < NOTE_EVERY_S }
        .collect { timeS -> container.settings.update { it.copy(walkedS = timeS) } }

    /** Keeps the notification true, and in the language that is chosen now. */
    private suspend fun notify(states: Flow<NavigationState>) =
        container.settings.settings.map { it.language }.distinctUntilChanged().collectLatest { language ->
            notification = NavigationNotification(this, language)
            states.map(notification::text).distinctUntilChanged().collect(notification::show)
        }

    /** Buttons of headsets, and in firefighter mode the volume keys, for as long as guidance runs. */
    private suspend fun buttons() =
        MediaControls(this, container.guide, container.clock, container.presence).use { buttons ->
            container.settings.settings.collect { buttons.takesVolumeKeys = it.firefighter }
        }

    private fun tellOfRecording(status: RecordingStatus) {
        if (status is RecordingStatus.Failed) container.guide.tell(Message.RecordingStopped(status.diskFull))
    }

    /** False when the system does not allow it now; a tap on the app then starts it. */
    private fun enterForeground(source: SourceKind): Boolean {
        val shown = notification.build(notification.text(container.navigator.state.value))
        return types(source).any { enterForeground(shown, it) }
    }

    private fun enterForeground(shown: Notification, type: Int): Boolean = try {
        ServiceCompat.startForeground(this, NavigationNotification.ID, shown, type)
        true
    } catch (_: SecurityException) {
        false // a connected device that is not plugged in yet, or not granted
    } catch (e: IllegalStateException) {
        if (Build.VERSION.SDK_INT < Build.VERSION_CODES.S || e !is ForegroundServiceStartNotAllowedException) throw e
        false
    }

    /**
     * The best first: since Android 14 there is no connected device before the belt is plugged in, and guidance
     * waits for it.
     */
    private fun types(source: SourceKind) = when {
        Build.VERSION.SDK_INT < Build.VERSION_CODES.UPSIDE_DOWN_CAKE ->
            listOf(ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE)
        source == SourceKind.USB ->
            listOf(
                ServiceInfo.FOREGROUND_SERVICE_TYPE_CONNECTED_DEVICE, ServiceInfo.FOREGROUND_SERVICE_TYPE_SPECIAL_USE,
            )
        else -> listOf(ServiceInfo.FOREGROUND_SERVICE_TYPE_SPECIAL_USE)
    }

    private fun stopNavigation() {
        // Silence would go on meaning that all is well.
        if (navigation?.isActive == true) container.guide.tell(Message.Stopped)
        navigation?.cancel()
        lifecycleScope.launch {
            container.settings.update { it.copy(navigating = false, goal = null) }
            ServiceCompat.stopForeground(this@NavigationService, ServiceCompat.STOP_FOREGROUND_REMOVE)
            stopSelf()
        }
    }

    override fun onDestroy() {
        wakeLock.release()
        super.onDestroy()
    }

    companion object {
        const val ACTION_START = "org.echoway.app.START"
        const val ACTION_STOP = "org.echoway.app.STOP"

        private const val NOTE_EVERY_S = 60.0

        /** Who begins later than this after the last echo has come anew, by the entrance. */
        private const val JUST_NOW_S = 600.0

        /** What the notification's buttons ask. */
        private val ASKS = Ask.entries.associateBy { actionOf(it) }

        fun actionOf(ask: Ask) = "org.echoway.app.$ask"

        fun intent(context: Context, action: String): Intent =
            Intent(context, NavigationService::class.java).setAction(action)

        fun start(context: Context) = ContextCompat.startForegroundService(context, intent(context, ACTION_START))

        fun send(context: Context, action: String) {
            context.startService(intent(context, action))
        }
    }
}
