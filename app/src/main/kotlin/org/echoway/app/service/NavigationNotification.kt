package org.echoway.app.service

import android.app.Notification
import android.app.NotificationChannel
import android.app.NotificationManager
import android.app.PendingIntent
import android.app.Service
import android.content.Intent
import android.widget.RemoteViews
import androidx.core.app.NotificationCompat
import org.echoway.app.MainActivity
import org.echoway.app.R
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Ask
import org.echoway.app.settings.inLanguage
import org.echoway.app.ui.StateWords
import org.echoway.core.Language

/** The ongoing notification, in [language] or the phone's own: the state in words, and buttons that ask. */
internal class NavigationNotification(private val service: Service, language: Language? = null) {
    private val manager = service.getSystemService(NotificationManager::class.java)
    private val resources = service.inLanguage(language).resources
    private val words = StateWords(resources)

    init {
        val name = resources.getString(R.string.channel_navigation)
        // Low: everything that matters is spoken, and a sound of its own would talk over it.
        manager.createNotificationChannel(NotificationChannel(CHANNEL, name, NotificationManager.IMPORTANCE_LOW))
    }

    val noBuilding: String get() = resources.getString(R.string.state_no_building)

    fun text(state: NavigationState): String = words.of(state)

    fun show(text: String) = manager.notify(ID, build(text))

    fun build(text: String): Notification = NotificationCompat.Builder(service, CHANNEL)
        .setSmallIcon(R.drawable.ic_notification)
        .setContentTitle(resources.getString(R.string.app_name))
        .setContentText(text)
        .setOngoing(true)
        .setOnlyAlertOnce(true)
        .setForegroundServiceBehavior(NotificationCompat.FOREGROUND_SERVICE_IMMEDIATE)
        .setContentIntent(activity())
        .setStyle(NotificationCompat.DecoratedCustomViewStyle())
        .setCustomBigContentView(controls(text))
        // Android shows three without unfolding.
        .addAction(0, resources.getString(R.string.where_am_i), command(NavigationService.actionOf(Ask.WHERE_AM_I)))
        .addAction(0, resources.getString(R.string.way_out), command(NavigationService.actionOf(Ask.WAY_OUT)))
        .addAction(0, resources.getString(R.string.stop), command(NavigationService.ACTION_STOP))
        .build()

    /** What does not fit among the three that Android shows. */
    private fun controls(text: String) = RemoteViews(service.packageName, R.layout.notification_controls).apply {
        setTextViewText(R.id.state, text)
        // Of the layout's own words the system would choose the phone's language.
        setTextViewText(R.id.repeat, resources.getString(R.string.repeat))
        setTextViewText(R.id.mute, resources.getString(R.string.mute_or_speak))
        setTextViewText(R.id.way_back, resources.getString(R.string.way_back_short))
        setOnClickPendingIntent(R.id.repeat, command(NavigationService.actionOf(Ask.REPEAT)))
        setOnClickPendingIntent(R.id.mute, command(NavigationService.actionOf(Ask.MUTE)))
        setOnClickPendingIntent(R.id.way_back, command(NavigationService.actionOf(Ask.WAY_BACK)))
    }

    private fun activity() =
        PendingIntent.getActivity(service, 0, Intent(service, MainActivity::class.java), PendingIntent.FLAG_IMMUTABLE)

    private fun command(action: String) =
        PendingIntent.getService(service, 0, NavigationService.intent(service, action), PendingIntent.FLAG_IMMUTABLE)

    companion object {
        const val ID = 1
        private const val CHANNEL = "navigation"
    }
}
