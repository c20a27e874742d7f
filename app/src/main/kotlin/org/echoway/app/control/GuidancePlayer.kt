package org.echoway.app.control

import android.os.Looper
import androidx.media3.common.DeviceInfo
import androidx.media3.common.MediaItem
import androidx.media3.common.MediaMetadata
import androidx.media3.common.Player
import androidx.media3.common.SimpleBasePlayer
import com.google.common.util.concurrent.Futures
import com.google.common.util.concurrent.ListenableFuture
import org.echoway.app.Clock
import org.echoway.app.guide.Ask
import org.echoway.app.guide.Asking

/**
 * Guidance as a media player that always plays: its buttons ask. "Next" and "previous" need something to go to, so it
 * says that it plays the middle one of three pieces.
 */
internal class GuidancePlayer(private val title: String, private val asking: Asking, private val clock: Clock) :
    SimpleBasePlayer(Looper.getMainLooper()) {
    private var pressedS = Double.NEGATIVE_INFINITY
    private var lastKey: VolumeKey? = null

    /** The volume keys ask too, even with the screen off; the volume is then the phone's as it was. */
    var takesVolumeKeys = false
        set(value) {
            field = value
            invalidateState()
        }

    override fun getState(): State = State.Builder()
        .setAvailableCommands(COMMANDS)
        .setPlaylist(PIECES.map { piece -> piece(piece) })
        .setCurrentMediaItemIndex(1)
        .setPlaybackState(STATE_READY)
        .setPlayWhenReady(true, PLAY_WHEN_READY_CHANGE_REASON_USER_REQUEST)
        .setDeviceInfo(if (takesVolumeKeys) KEYS else LOUDSPEAKER)
        .setDeviceVolume(if (takesVolumeKeys) VOLUME else 0)
        .build()

    override fun handleSetPlayWhenReady(playWhenReady: Boolean) = ask(Ask.WHERE_AM_I)

    override fun handleSeek(
        mediaItemIndex: Int,
        positionMs: Long,
        seekCommand: Int,
    ): ListenableFuture<*> = when (seekCommand) {
        COMMAND_SEEK_TO_NEXT, COMMAND_SEEK_TO_NEXT_MEDIA_ITEM -> ask(Ask.REPEAT)
        COMMAND_SEEK_TO_PREVIOUS, COMMAND_SEEK_TO_PREVIOUS_MEDIA_ITEM -> ask(Ask.WAY_OUT)
        else -> Futures.immediateVoidFuture()
    }

    override fun handleStop() = ask(Ask.MUTE)

    override fun handleIncreaseDeviceVolume(flags: Int) = onKey(VolumeKey.UP)

    override fun handleDecreaseDeviceVolume(flags: Int) = onKey(VolumeKey.DOWN)

    override fun handleSetDeviceVolume(deviceVolume: Int, flags: Int): ListenableFuture<*> = when {
        deviceVolume > VOLUME -> onKey(VolumeKey.UP)
        deviceVolume < VOLUME -> onKey(VolumeKey.DOWN)
        else -> Futures.immediateVoidFuture()
    }

    override fun handleRelease(): ListenableFuture<*> = Futures.immediateVoidFuture()

    private fun ask(ask: Ask): ListenableFuture<*> {
        asking.ask(ask)
        return Futures.immediateVoidFuture()
    }

    /**
     * A key that is held, in a glove, repeats itself. Both pressed together come one after the other: the second
     * asks nothing more.
     */
    private fun onKey(key: VolumeKey): ListenableFuture<*> {
        val now = clock.nowS()
        val asksNoMore = now - pressedS < if (key == lastKey) HELD_S else TOGETHER_S
        pressedS = now
        lastKey = key
        return if (asksNoMore) Futures.immediateVoidFuture() else ask(key.alone)
    }

    private fun piece(name: String) = MediaItemData.Builder(name)
        .setMediaItem(MediaItem.Builder().setMediaId(name).build())
        .setMediaMetadata(MediaMetadata.Builder().setTitle(title).build())
        .build()

    private companion object {
        val PIECES = listOf("before", "guidance", "after")
        const val HELD_S = 1.0
        const val TOGETHER_S = 0.3
        const val VOLUME = 1
        val LOUDSPEAKER: DeviceInfo = DeviceInfo.Builder(DeviceInfo.PLAYBACK_TYPE_LOCAL).build()
        val KEYS: DeviceInfo =
            DeviceInfo.Builder(DeviceInfo.PLAYBACK_TYPE_REMOTE).setMinVolume(0).setMaxVolume(2 * VOLUME).build()
        val COMMANDS: Player.Commands = Player.Commands.Builder().addAll(
            COMMAND_PLAY_PAUSE, COMMAND_STOP, COMMAND_RELEASE, COMMAND_SEEK_TO_NEXT, COMMAND_SEEK_TO_PREVIOUS,
            COMMAND_SEEK_TO_NEXT_MEDIA_ITEM, COMMAND_SEEK_TO_PREVIOUS_MEDIA_ITEM, COMMAND_GET_CURRENT_MEDIA_ITEM,
            COMMAND_GET_TIMELINE, COMMAND_GET_METADATA, COMMAND_GET_DEVICE_VOLUME, COMMAND_SET_DEVICE_VOLUME_WITH_FLAGS,
            COMMAND_ADJUST_DEVICE_VOLUME_WITH_FLAGS,
        ).build()
    }
}
