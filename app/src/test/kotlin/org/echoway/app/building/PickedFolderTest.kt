package org.echoway.app.building

import android.content.ContentProvider
import android.content.ContentValues
import android.content.Context
import android.content.pm.ProviderInfo
import android.database.Cursor
import android.database.MatrixCursor
import android.net.Uri
import android.os.ParcelFileDescriptor
import android.provider.DocumentsContract
import android.provider.DocumentsContract.Document
import androidx.test.core.app.ApplicationProvider
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import org.echoway.core.PlanLoader
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertThrows
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith
import org.robolectric.shadows.ShadowContentResolver

/** A folder from the system's picker, whose provider may say anything. */
@RunWith(AndroidJUnit4::class)
class PickedFolderTest {
    @get:Rule val temporary = TemporaryFolder()

    private val context = ApplicationProvider.getApplicationContext<Context>()
    private val provider = FolderProvider()
    private val home get() = File(temporary.root, "home")
    private val import get() = BuildingImport(home, File(temporary.root, "workshop"))

    @Before fun register() {
        provider.attachInfo(context, ProviderInfo().apply { authority = AUTHORITY })
        ShadowContentResolver.registerProviderInternal(AUTHORITY, provider)
    }

    private fun picked(limits: ImportLimits = ImportLimits()) =
        PickedFolder(context.contentResolver, DocumentsContract.buildTreeDocumentUri(AUTHORITY, "root"), limits)

    private fun twoRooms() =
        File(System.getProperty("echoway.root")!!, "maps/two-rooms").listFiles()!!.filter { it.isFile }

    private fun assertRefused(problem: ImportProblem, limits: ImportLimits = ImportLimits()) {
        assertEquals(problem, assertThrows(ImportException::class.java) { import.folder("a", picked(limits)) }.problem)
        assertFalse(File(temporary.root, "workshop").exists())
        assertEquals(0, home.list().orEmpty().size)
    }

    @Test fun aGoodFolderBecomesABuilding() {
        twoRooms().forEach { provider.add("root", it.name, it) }
        assertEquals("two-rooms", import.folder("Two rooms", picked()).id)
        assertEquals(2, PlanLoader.load(File(home, "two-rooms")).rooms.size)
    }

    @Test fun theBuildingMayLieInAFolderOfTheFolder() {
        provider.add("root", "export", null)
        twoRooms().forEach { provider.add("root/export", it.name, it) }
        assertEquals("a", import.folder("a", picked()).id)
    }

    @Test fun namesThatLeadOutAreRefused() {
        twoRooms().forEach { provider.add("root", it.name, it) }
        provider.add("root", "../treasure", twoRooms().first())
        assertRefused(ImportProblem.UNSAFE_NAME)
    }

    @Test fun aFolderThatHoldsItselfIsRefused() {
        provider.add("root", "again", null, id = "root")
        assertRefused(ImportProblem.TOO_MANY_FILES)
    }

    @Test fun tooManyFilesAreRefused() {
        repeat(20) { provider.add("root", "f$it", twoRooms().first()) }
        assertRefused(ImportProblem.TOO_MANY_FILES, ImportLimits(files = 10))
    }

    @Test fun aProviderThatFailsIsTold() {
        provider.add("root", "building.cfg", File("/nowhere"))
        assertRefused(ImportProblem.UNREADABLE)
    }

    @Test fun aProviderThatTakesItsLeaveBackIsTold() {
        provider.failure = SecurityException("no leave any more")
        assertRefused(ImportProblem.UNREADABLE)
        provider.failure = null
        provider.add("root", "building.cfg", twoRooms().first())
        provider.openFailure = IllegalStateException("no connection")
        assertRefused(ImportProblem.UNREADABLE)
    }

    private companion object {
        const val AUTHORITY = "org.echoway.test.documents"
    }
}

/** Answers as a documents provider does, from a table. */
private class FolderProvider : ContentProvider() {
    private class Entry(val id: String, val parent: String, val name: String, val file: File?)

    private val entries = mutableListOf<Entry>()
    var failure: RuntimeException? = null
    var openFailure: RuntimeException? = null

    fun add(parent: String, name: String, file: File?, id: String = "$parent/$name") {
        entries += Entry(id, parent, name, file)
    }

    override fun onCreate() = true

    override fun query(
        uri: Uri,
        columns: Array<String>?,
        selection: String?,
        arguments: Array<String>?,
        order: String?,
    ): Cursor {
        failure?.let { throw it }
        val parent = DocumentsContract.getDocumentId(uri)
        val rows =
            MatrixCursor(arrayOf(Document.COLUMN_DOCUMENT_ID, Document.COLUMN_DISPLAY_NAME, Document.COLUMN_MIME_TYPE))
        entries.filter { it.parent == parent }.forEach {
            rows.addRow(arrayOf(it.id, it.name, if (it.file == null) Document.MIME_TYPE_DIR else "text/plain"))
        }
        return rows
    }

    override fun openFile(uri: Uri, mode: String): ParcelFileDescriptor {
        openFailure?.let { throw it }
        val id = DocumentsContract.getDocumentId(uri)
        return ParcelFileDescriptor.open(entries.first { it.id == id }.file!!, ParcelFileDescriptor.MODE_READ_ONLY)
    }

    override fun getType(uri: Uri): String? = null

    override fun insert(uri: Uri, values: ContentValues?): Uri? = null

    override fun delete(uri: Uri, selection: String?, arguments: Array<String>?) = 0

    override fun update(uri: Uri, values: ContentValues?, selection: String?, arguments: Array<String>?) = 0
}
