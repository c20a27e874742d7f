package org.echoway.app.privacy

import android.content.Context
import android.content.pm.ApplicationInfo
import android.content.pm.PackageManager
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.junit.Assert.assertEquals
import org.junit.Test
import org.junit.runner.RunWith

/** What the installed app may do, its libraries' wishes included: this reads the merged manifest. */
@RunWith(AndroidJUnit4::class)
class ManifestTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val installed = context.packageManager.getPackageInfo(context.packageName, PackageManager.GET_PERMISSIONS)

    @Test fun nothingButTheseIsAskedFor() {
        val own = "${context.packageName}.DYNAMIC_RECEIVER_NOT_EXPORTED_PERMISSION"
        val expected = listOf(
            "ACTIVITY_RECOGNITION", "FOREGROUND_SERVICE", "FOREGROUND_SERVICE_CONNECTED_DEVICE", "FOREGROUND_SERVICE_SPECIAL_USE",
            "POST_NOTIFICATIONS", "VIBRATE", "WAKE_LOCK",
        ).map { "android.permission.$it" }
        val ofTheTests = "android.permission.REORDER_TASKS"
        assertEquals(expected.toSet(), installed.requestedPermissions!!.toSet() - own - ofTheTests)
    }

    @Test fun nothingIsBackedUp() {
        assertEquals(0, installed.applicationInfo!!.flags and ApplicationInfo.FLAG_ALLOW_BACKUP)
    }
}
