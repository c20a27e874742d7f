package org.echoway.app

import android.Manifest
import android.app.Activity
import android.content.Intent
import android.hardware.usb.UsbManager
import androidx.test.core.app.ActivityScenario
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.Job
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import org.echoway.app.belt.BeltSource
import org.echoway.app.engine.NavigationState
import org.echoway.app.service.NavigationService
import org.echoway.app.service.TestApp
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.ScriptedBelt
import org.echoway.core.Start
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

    private fun launch(intent: Intent, test: (Activity) -> Unit) =
        ActivityScenario.launch<MainActivity>(intent).use { scenario ->
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

    /** Begun anew, guidance would take the wearer to be back at the entrance. */
    @Test fun aBeltThatFellOutAndIsPluggedInAgainDoesNotBeginGuidanceAnew() {
        shadowOf(app).grantPermissions(Manifest.permission.POST_NOTIFICATIONS, Manifest.permission.ACTIVITY_RECOGNITION)
        val guided = guided(ScriptedBelt(bringsMotion = false))
        launch(plugged) { assertNull(shadowOf(app).nextStartedService) }
        guided.cancel()
        ShadowLooper.idleMainLooper()
        launch(plugged) { assertEquals(NavigationService.ACTION_START, shadowOf(app).nextStartedService?.action) }
    }

    @Test fun pluggingTheBeltInEndsAWalkThatIsReplayed() {
        shadowOf(app).grantPermissions(Manifest.permission.POST_NOTIFICATIONS, Manifest.permission.ACTIVITY_RECOGNITION)
        val guided = guided(ScriptedBelt(bringsMotion = true))
        launch(plugged) { assertEquals(NavigationService.ACTION_START, shadowOf(app).nextStartedService?.action) }
        guided.cancel()
    }

    /** Guidance with a belt, under way. */
    private fun guided(belt: BeltSource): Job {
        val navigator = app.container.navigator
        val job = MainScope().launch {
            navigator.run(app.container.buildings.find("torgersen-lab")!!, Start(), belt, app.container.motion)
        }
        repeat(500) {
            if (navigator.state.value is NavigationState.Running) return job
            ShadowLooper.idleMainLooper(20, TimeUnit.MILLISECONDS)
            Thread.sleep(2)
        }
        throw AssertionError("guidance does not run: ${navigator.state.value}")
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
