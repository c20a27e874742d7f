package org.echoway.app

import android.Manifest
import android.content.Intent
import android.content.pm.PackageManager
import android.hardware.usb.UsbManager
import android.net.Uri
import android.os.Build
import android.os.Bundle
import android.view.KeyEvent
import androidx.activity.ComponentActivity
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.RequestMultiplePermissions
import androidx.activity.viewModels
import androidx.lifecycle.lifecycleScope
import androidx.lifecycle.viewmodel.initializer
import androidx.lifecycle.viewmodel.viewModelFactory
import kotlinx.coroutines.launch
import org.echoway.app.control.VolumeChords
import org.echoway.app.control.VolumeKey
import org.echoway.app.engine.NavigationState
import org.echoway.app.service.NavigationService
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.app.ui.ActivityActions
import org.echoway.app.ui.EchowayUi
import org.echoway.app.ui.setup.SetupViewModel

class MainActivity : ComponentActivity() {
    private val setup by viewModels<SetupViewModel> { viewModelFactory { initializer { SetupViewModel(container) } } }

    // Guidance starts whatever the answer is: without notifications it still speaks, without steps it still locates.
    private val permissions = registerForActivityResult(RequestMultiplePermissions()) { NavigationService.start(this) }
    private val chords by lazy { VolumeChords(container.guide) }
    private var firefighter = false
    private val recording = registerForActivityResult(OpenDocument()) { uri -> uri?.let(::useRecording) }

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        enableEdgeToEdge()
        setContent {
            EchowayUi(container, setup, ActivityActions(start = ::start, stop = ::stop) { recording.launch(LOG_TYPES) })
        }
        lifecycleScope.launch { container.settings.settings.collect(::follow) }
        if (savedInstanceState == null) onUsbAttached(intent)
    }

    override fun onNewIntent(intent: Intent) {
        super.onNewIntent(intent)
        onUsbAttached(intent)
    }

    /**
     * Plugging the belt in starts guidance; Android has then granted the use of the device. Guidance that waits for a
     * belt which fell out goes on by itself: begun anew, it would take the wearer to be back at the entrance.
     */
    private fun onUsbAttached(intent: Intent) {
        if (intent.action != UsbManager.ACTION_USB_DEVICE_ATTACHED || container.navigator.isLive) return
        lifecycleScope.launch {
            container.settings.update { it.copy(source = SourceKind.USB) }
            start()
        }
    }

    /**
     * Chords of the volume keys ask where they are chosen; a single key stays the volume's. In firefighter mode
     * guidance's media session asks at every key that it is handed: it gets none from here, or a chord would ask as its
     * first key does, too.
     */
    override fun dispatchKeyEvent(event: KeyEvent): Boolean {
        chords.loneKeysAsk = firefighter && container.navigator.state.value is NavigationState.Running
        val key = VOLUME_KEYS[event.keyCode]?.takeIf {
            (chords.chordsAsk || chords.loneKeysAsk) && event.action in KEY_ACTIONS
        }
            ?: return super.dispatchKeyEvent(event)
        if (event.isCanceled) {
            chords.onTakenBack(key)
            return super.dispatchKeyEvent(event)
        }
        return chords.onKey(key, event.action == KeyEvent.ACTION_DOWN, event.eventTime) || super.dispatchKeyEvent(event)
    }

    private fun follow(settings: Settings) {
        chords.chordsAsk = settings.volumeKeys
        firefighter = settings.firefighter
        // Whoever is to find a firefighter must reach "Cancel alarm" on a locked phone.
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.O_MR1) setShowWhenLocked(settings.firefighter)
    }

    private fun start() {
        val missing = wanted().filter { checkSelfPermission(it) != PackageManager.PERMISSION_GRANTED }
        if (missing.isEmpty()) NavigationService.start(this) else permissions.launch(missing.toTypedArray())
    }

    private fun stop() = NavigationService.send(this, NavigationService.ACTION_STOP)

    private fun wanted() = buildList {
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.TIRAMISU) add(Manifest.permission.POST_NOTIFICATIONS)
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.Q) add(Manifest.permission.ACTIVITY_RECOGNITION)
    }

    private fun useRecording(uri: Uri) =
        setup.useRecording(nameOf(uri).ifEmpty { "walk.scans.csv" }) { contentResolver.openPicked(uri) }

    private companion object {
        val VOLUME_KEYS =
            mapOf(KeyEvent.KEYCODE_VOLUME_UP to VolumeKey.UP, KeyEvent.KEYCODE_VOLUME_DOWN to VolumeKey.DOWN)
        val KEY_ACTIONS = setOf(KeyEvent.ACTION_DOWN, KeyEvent.ACTION_UP)

        /** Providers disagree on what a CSV file is. */
        val LOG_TYPES = arrayOf("text/*", "application/octet-stream")
    }
}
