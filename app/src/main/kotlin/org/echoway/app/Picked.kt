package org.echoway.app

import android.content.ContentResolver
import android.content.Context
import android.net.Uri
import android.provider.OpenableColumns
import java.io.FileNotFoundException
import java.io.IOException
import java.io.InputStream

/** What its provider calls a document; empty where it does not say. */
fun Context.nameOf(uri: Uri): String = runCatching {
    contentResolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
        ?.use { if (it.moveToFirst()) it.getString(0) else null }
}.getOrNull().orEmpty()

/** @throws IOException when the document is not to be had */
fun ContentResolver.openPicked(uri: Uri): InputStream = provided { openInputStream(uri) } ?: throw FileNotFoundException("$uri")

/** Providers are other apps, and fail with whatever exception they fail with. */
fun <T> provided(ask: () -> T): T = try {
    ask()
} catch (e: RuntimeException) {
    throw IOException(e)
}
