package org.echoway.app.building

import android.content.ContentResolver
import android.net.Uri
import android.provider.DocumentsContract
import android.provider.DocumentsContract.Document
import java.io.InputStream
import org.echoway.app.openPicked
import org.echoway.app.provided

/** The files below a folder that was picked with the system's picker. */
class PickedFolder(
    private val resolver: ContentResolver,
    private val tree: Uri,
    private val limits: ImportLimits,
) : BuildingFiles {
    private var seen = 0

    override fun forEach(visit: (path: String, open: () -> InputStream) -> Unit) {
        seen = 0
        visitFolder(DocumentsContract.getTreeDocumentId(tree), "", 0, visit)
    }

    private fun visitFolder(id: String, path: String, depth: Int, visit: (String, () -> InputStream) -> Unit) {
        // A provider may answer with folders that hold themselves.
        if (depth > limits.depth) throw ImportException(ImportProblem.TOO_MANY_FILES, path)
        for (child in children(id)) {
            if (++seen > limits.files) throw ImportException(ImportProblem.TOO_MANY_FILES)
            if (child.isFolder) {
                visitFolder(child.id, "$path${child.name}/", depth + 1, visit)
            } else {
                visit("$path${child.name}") { open(child.id) }
            }
        }
    }

    private class Child(val id: String, val name: String, val isFolder: Boolean)

    private fun children(id: String): List<Child> {
        val uri = DocumentsContract.buildChildDocumentsUriUsingTree(tree, id)
        val columns = arrayOf(Document.COLUMN_DOCUMENT_ID, Document.COLUMN_DISPLAY_NAME, Document.COLUMN_MIME_TYPE)
        val cursor = provided { resolver.query(uri, columns, null, null, null) }
            ?: throw ImportException(ImportProblem.UNREADABLE)
        return cursor.use {
            buildList {
                while (it.moveToNext() && size <= limits.files) {
                    add(Child(it.getString(0), it.getString(1).orEmpty(), it.getString(2) == Document.MIME_TYPE_DIR))
                }
            }
        }
    }

    private fun open(id: String): InputStream =
        resolver.openPicked(DocumentsContract.buildDocumentUriUsingTree(tree, id))
}
