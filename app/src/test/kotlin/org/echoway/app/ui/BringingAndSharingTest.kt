package org.echoway.app.ui

import android.content.ClipboardManager
import android.content.Intent
import android.net.Uri
import androidx.compose.ui.test.assertIsDisplayed
import androidx.compose.ui.test.hasAnyAncestor
import androidx.compose.ui.test.hasContentDescription
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.isDialog
import androidx.compose.ui.test.junit4.v2.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.File
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import org.echoway.app.MainActivity
import org.echoway.app.service.NavigationService
import org.echoway.app.service.TestApp
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.forgetSharedFolders
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config

/** Buildings, recordings and reports come and go through the system's own pickers, sheet and clipboard. */
@RunWith(AndroidJUnit4::class)
@Config(application = TestApp::class, qualifiers = "w400dp-h860dp-xhdpi")
class BringingAndSharingTest {
    @get:Rule val rule = createAndroidComposeRule<MainActivity>()

    private val app = ApplicationProvider.getApplicationContext<TestApp>()
    private val settings get() = app.container.settings.settings
    private val activity get() = shadowOf(rule.activity)

    @Before fun forget() = forgetSharedFolders()

    private fun await(words: String) =
        rule.waitUntil(WAIT_MS) { rule.onAllNodes(hasText(words, substring = true)).fetchSemanticsNodes().isNotEmpty() }

    private fun tap(vararg titles: String) = titles.forEach { title ->
        await(title)
        val node = rule.onNodeWithText(title)
        runCatching { node.performScrollTo() } // what stands outside a list needs no scrolling
        node.performClick()
    }

    private fun pick(button: String, bytes: ByteArray): Intent {
        tap("Menu", "Buildings", button)
        rule.waitForIdle()
        val asked = activity.nextStartedActivityForResult.intent
        val uri = Uri.parse("content://somewhere/archive")
        shadowOf(app.contentResolver).registerInputStream(uri, ByteArrayInputStream(bytes))
        activity.receiveResult(asked, android.app.Activity.RESULT_OK, Intent().setData(uri))
        return asked
    }

    private fun twoRooms(): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            File(System.getProperty("echoway.root")!!, "maps/two-rooms").listFiles()!!.filter { it.isFile }.forEach {
                zip.putNextEntry(ZipEntry("mine/${it.name}"))
                zip.write(it.readBytes())
            }
        }
        return bytes.toByteArray()
    }

    @Test fun aBuildingComesInThroughThePickerIsChosenAndCanBeDeletedAgain() {
        val asked = pick("Bring in a building from a zip archive…", twoRooms())
        assertEquals(Intent.ACTION_OPEN_DOCUMENT, asked.action)
        await("is here, and chosen.")
        assertEquals("building", settings.value.building)
        val delete = hasContentDescription("Delete: ", substring = true)
        rule.waitUntil(WAIT_MS) { rule.onAllNodes(delete).fetchSemanticsNodes().isNotEmpty() }
        rule.onNode(delete).performScrollTo().performClick()
        rule.onNode(hasText("Delete") and hasAnyAncestor(isDialog())).performClick()
        await("is deleted.")
        assertEquals(null, settings.value.building)
    }

    @Test fun aBrokenArchiveIsRefusedInPlainWordsAndWhatWasChosenStays() {
        pick("Bring in a building from a zip archive…", twoRooms().copyOf(200))
        await("This is not a zip archive, or it was cut short.")
        assertEquals("torgersen-lab", settings.value.building)
    }

    @Test fun aFolderIsAskedForWithThePickerForFolders() {
        tap("Menu", "Buildings", "Bring in a building from a folder…")
        rule.waitForIdle()
        assertEquals(Intent.ACTION_OPEN_DOCUMENT_TREE, activity.nextStartedActivityForResult.intent.action)
    }

    private fun record() = File(app.container.recordings.folder, "2026-11-25_20-15-03.scans.csv").let {
        it.parentFile!!.mkdirs()
        it.writeText("# building two-rooms\n# sensors 3\ntime_s,sensor,range_m\n0.0,0,1.5\n0.0624,1,\n")
        File(it.parentFile, "2026-11-25_20-15-03.track.csv").writeText("time_s\n")
    }

    @Test fun aRecordingIsSharedWithAllItsFilesAndNothingElse() {
        record()
        tap("Menu", "Recordings", "Share…")
        rule.waitForIdle()
        val chooser = activity.nextStartedActivity
        assertEquals(Intent.ACTION_CHOOSER, chooser.action)
        @Suppress("DEPRECATION")
        val sent = chooser.getParcelableExtra<Intent>(Intent.EXTRA_INTENT)!!
        assertTrue(sent.flags and Intent.FLAG_GRANT_READ_URI_PERMISSION != 0)
        @Suppress("DEPRECATION")
        assertEquals(
            listOf("2026-11-25_20-15-03.scans.csv", "2026-11-25_20-15-03.track.csv"),
            sent.getParcelableArrayListExtra<Uri>(Intent.EXTRA_STREAM)!!.map { it.lastPathSegment },
        )
    }

    @Test fun aRecordingIsReplayedInTheBuildingWhereItWasMade() {
        record()
        shadowOf(app).grantPermissions(
            "android.permission.POST_NOTIFICATIONS", "android.permission.ACTIVITY_RECOGNITION",
        )
        tap("Menu", "Recordings", "Replay")
        rule.waitUntil(WAIT_MS) { settings.value.source == SourceKind.RECORDING }
        assertEquals("2026-11-25_20-15-03.scans.csv", settings.value.recording)
        assertEquals("two-rooms", settings.value.building)
        rule.waitUntil(WAIT_MS) { shadowOf(app).peekNextStartedService()?.action == NavigationService.ACTION_START }
    }

    @Test fun aReportIsCopiedAsText() {
        tap("Menu", "Diagnostics", "Copy as text, without positions")
        val text = app.getSystemService(ClipboardManager::class.java).primaryClip!!.getItemAt(0).text
        assertTrue("$text", text.startsWith("Echoway ") && "No belt was heard yet." in text)
        rule.onNodeWithText("No belt was heard yet.").assertIsDisplayed()
    }

    private companion object {
        const val WAIT_MS = 10_000L
    }
}
