package org.echoway.app.privacy

import android.content.Context
import android.content.pm.ApplicationInfo
import android.content.pm.PackageManager
import androidx.core.content.FileProvider
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import org.echoway.app.R
import org.echoway.app.testing.forgetSharedFolders
import org.junit.Assert.assertEquals
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.xmlpull.v1.XmlPullParser

/** What the installed app may do, its libraries' wishes included: this reads the merged manifest. */
@RunWith(AndroidJUnit4::class)
class ManifestTest {
    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val installed = context.packageManager.getPackageInfo(context.packageName, PackageManager.GET_PERMISSIONS)

    @Test fun nothingButTheseIsAskedFor() {
        val own = "${context.packageName}.DYNAMIC_RECEIVER_NOT_EXPORTED_PERMISSION"
        val expected = listOf(
            "ACTIVITY_RECOGNITION", "FOREGROUND_SERVICE", "FOREGROUND_SERVICE_CONNECTED_DEVICE",
            "FOREGROUND_SERVICE_SPECIAL_USE",
            "POST_NOTIFICATIONS", "VIBRATE", "WAKE_LOCK",
        ).map { "android.permission.$it" }
        val ofTheTests = "android.permission.REORDER_TASKS"
        assertEquals(expected.toSet(), installed.requestedPermissions!!.toSet() - own - ofTheTests)
    }

    @Test fun nothingIsBackedUp() {
        assertEquals(0, installed.applicationInfo!!.flags and ApplicationInfo.FLAG_ALLOW_BACKUP)
    }

    /** Since Android 12 a move to another phone asks these rules alone. */
    @Test fun nothingMovesToAnotherPhoneByItself() {
        val excluded = mutableMapOf<String, MutableSet<String>>()
        val rules = context.resources.getXml(R.xml.data_extraction_rules)
        var section = ""
        while (rules.next() != XmlPullParser.END_DOCUMENT) {
            if (rules.eventType != XmlPullParser.START_TAG) continue
            if (rules.name == "exclude") {
                excluded.getOrPut(section) { mutableSetOf() } += rules.getAttributeValue(null, "domain")
            } else {
                section = rules.name
            }
        }
        val everything = setOf("root", "file", "database", "sharedpref", "external")
        assertEquals(mapOf("cloud-backup" to everything, "device-transfer" to everything), excluded)
        val manifest = File(System.getProperty("echoway.root")!!, "app/src/main/AndroidManifest.xml").readText()
        assertTrue("android:dataExtractionRules=\"@xml/data_extraction_rules\"" in manifest)
    }

    @Test fun onlyRecordingsCanBeShared() {
        forgetSharedFolders()
        val recording = File(context.filesDir, "recordings/a.scans.csv")
        assertEquals(
            "content://${context.packageName}.files/recordings/a.scans.csv",
            FileProvider.getUriForFile(context, "${context.packageName}.files", recording).toString(),
        )
        val settings = File(context.filesDir, "datastore/settings.preferences_pb")
        assertThrows(IllegalArgumentException::class.java) {
            FileProvider.getUriForFile(context, "${context.packageName}.files", settings)
        }
    }
}
