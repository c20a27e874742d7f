package org.echoway.app.control

import android.content.Context
import android.os.Handler
import androidx.media3.session.MediaSession
import java.io.Closeable
import org.echoway.app.Clock
import org.echoway.app.R
import org.echoway.app.guide.Asking

/** The buttons of headsets, cars and watches, for as long as guidance runs. */
class MediaControls(context: Context, asking: Asking, clock: Clock, presence: Presence) : Closeable {
    private val player = GuidancePlayer(context.getString(R.string.app_name), asking, clock)
    private val keys = MediaKeys(asking, Handler(player.applicationLooper))
    internal val session: MediaSession =
        MediaSession.Builder(context, player).setId("guidance").setCallback(keys).build()

    /** The volume keys ask, with the screen off too. */
    var takesVolumeKeys by player::takesVolumeKeys

    init {
        presence.claim()
    }

    override fun close() {
        keys.close()
        session.release()
        player.release()
    }
}
