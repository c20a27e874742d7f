package org.echoway.app.control

import android.annotation.SuppressLint
import android.app.PendingIntent
import android.content.Intent
import android.os.Build
import android.service.quicksettings.Tile
import android.service.quicksettings.TileService
import org.echoway.app.MainActivity
import org.echoway.app.R
import org.echoway.app.container
import org.echoway.app.engine.NavigationState
import org.echoway.app.guide.Ask

/**
 * "Where am I?" among the quick settings: two fingers down from the top, on the lock screen too. Without guidance it
 * opens the app.
 */
class WhereAmITile : TileService() {
    private val running get() = container.navigator.state.value is NavigationState.Running

    override fun onStartListening() {
        container.guide // reads meanwhile in which language to answer
        val tile = qsTile ?: return
        tile.state = if (running) Tile.STATE_ACTIVE else Tile.STATE_INACTIVE
        tile.label = getString(R.string.where_am_i)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) {
            tile.subtitle = getString(if (running) R.string.app_name else R.string.state_off)
        }
        tile.updateTile()
    }

    override fun onClick() {
        container.guide.ask(Ask.WHERE_AM_I)
        if (!running) unlockAndRun(::openApp)
    }

    @SuppressLint("StartActivityAndCollapseDeprecated") // the other way is refused from Android 14 on, this one before
    private fun openApp() {
        val intent = Intent(this, MainActivity::class.java).addFlags(Intent.FLAG_ACTIVITY_NEW_TASK)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.UPSIDE_DOWN_CAKE) {
            startActivityAndCollapse(PendingIntent.getActivity(this, 0, intent, PendingIntent.FLAG_IMMUTABLE))
        } else {
            @Suppress("DEPRECATION")
            startActivityAndCollapse(intent)
        }
    }
}
