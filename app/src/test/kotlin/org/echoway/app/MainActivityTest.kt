package org.echoway.app

import android.Manifest
import android.app.Activity
import android.content.Intent
import android.hardware.usb.UsbManager
import androidx.test.core.app.ActivityScenario
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.echoway.app.service.NavigationService
import org.echoway.app.service.TestApp
import org.echoway.app.settings.SourceKind
import org.junit.Assert.assertArrayEquals
import org.junit.Assert.assertEquals
import org.junit.Assert.assertNull
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.shadows.ShadowLooper

@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class)
class MainActivityTest {
    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val plugged = Intent(app, MainActivity::class.java).setAction(UsbManager.ACTION_USB_DEVICE_ATTACHED)

    private fun launch(intent: Intent, test: (Activity) -> Unit) = ActivityScenario.launch<MainActivity>(intent).use { scenario ->
        ShadowLooper.idleMainLooper()
        scenario.onActivity(test)
    }

    @Test fun pluggingTheBeltInStartsGuidanceWithIt() {
        shadowOf(app).grantPermissions(Manifest.permission.POST_NOTIFICATIONS, Manifest.permission.ACTIVITY_RECOGNITION)
        launch(plugged) {
            assertEquals(SourceKind.USB, app.container.settings.settings.value.source)
            assertEquals(NavigationService.ACTION_START, shadowOf(app).nextStartedService?.action)
        }
    }

    @Test fun asksForWhatItLacksBeforeTheFirstStart() {
        launch(plugged) { activity ->
            val request = shadowOf(activity).lastRequestedPermission
            assertArrayEquals(
                arrayOf(Manifest.permission.POST_NOTIFICATIONS, Manifest.permission.ACTIVITY_RECOGNITION),
                request.requestedPermissions,
            )
        }
    }

    @Test fun openingTheAppStartsNothing() {
        launch(Intent(app, MainActivity::class.java)) { assertNull(shadowOf(app).nextStartedService) }
    }
}
