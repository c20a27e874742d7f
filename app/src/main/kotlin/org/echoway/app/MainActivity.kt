package org.echoway.app

import android.Manifest
import android.content.Intent
import android.content.pm.PackageManager
import android.hardware.usb.UsbManager
import android.net.Uri
import android.os.Build
import android.os.Bundle
import android.provider.OpenableColumns
import androidx.activity.ComponentActivity
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.RequestMultiplePermissions
import androidx.activity.viewModels
import androidx.lifecycle.lifecycleScope
import androidx.lifecycle.viewmodel.initializer
import androidx.lifecycle.viewmodel.viewModelFactory
import java.io.FileNotFoundException
import kotlinx.coroutines.launch
import org.echoway.app.service.NavigationService
import org.echoway.app.settings.SourceKind
import org.echoway.app.ui.ActivityActions
import org.echoway.app.ui.EchowayUi
import org.echoway.app.ui.setup.SetupViewModel

class MainActivity : ComponentActivity() {
    private val setup by viewModels<SetupViewModel> {
        viewModelFactory { initializer { SetupViewModel(container, getString(R.string.entrance_unknown)) } }
    }

    // Guidance starts whatever the answer is: without notifications it still speaks, without steps it still locates.
    private val permissions = registerForActivityResult(RequestMultiplePermissions()) { NavigationService.start(this) }
    private val recording = registerForActivityResult(OpenDocument()) { uri -> uri?.let(::useRecording) }

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        enableEdgeToEdge()
        setContent {
            EchowayUi(container, setup, ActivityActions(start = ::start, stop = ::stop) { recording.launch(LOG_TYPES) })
        }
        if (savedInstanceState == null) onUsbAttached(intent)
    }

    override fun onNewIntent(intent: Intent) {
        super.onNewIntent(intent)
        onUsbAttached(intent)
    }

    /** Plugging the belt in starts guidance; Android has then granted the use of the device. */
    private fun onUsbAttached(intent: Intent) {
        if (intent.action != UsbManager.ACTION_USB_DEVICE_ATTACHED) return
        lifecycleScope.launch {
            container.settings.update { it.copy(source = SourceKind.USB) }
            start()
        }
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

    private fun useRecording(uri: Uri) {
        val name = contentResolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
            ?.use { if (it.moveToFirst()) it.getString(0) else null }
        setup.useRecording(name ?: "walk.scans.csv") {
            contentResolver.openInputStream(uri) ?: throw FileNotFoundException(uri.toString())
        }
    }

    private companion object {
        /** Providers disagree on what a CSV file is. */
        val LOG_TYPES = arrayOf("text/*", "application/octet-stream")
    }
}
