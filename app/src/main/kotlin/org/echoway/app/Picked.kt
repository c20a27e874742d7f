package org.echoway.app

import android.content.ContentResolver
import android.content.Context
import android.net.Uri
import android.provider.OpenableColumns
import java.io.File
import java.io.FileNotFoundException
import java.io.IOException
import java.io.InputStream

/** What its provider calls a document; empty where it does not say. */
fun Context.nameOf(uri: Uri): String = runCatching {
    contentResolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
        ?.use { if (it.moveToFirst()) it.getString(0) else null }
}.getOrNull().orEmpty()

/** @throws IOException when the document is not to be had */
fun ContentResolver.openPicked(uri: Uri): InputStream =
    provided { openInputStream(uri) } ?: throw FileNotFoundException("$uri")

/**
 * Copies it to [to] if it holds at most [most] bytes, and returns how many; null if it holds more: it must not
 * fill the phone.
 */
fun InputStream.copyAtMost(most: Long, to: File): Long? {
    val buffer = ByteArray(BUFFER_BYTES)
    var total = 0L
    to.outputStream().use { out ->
        var read = read(buffer)
        while (read >= 0) {
            total += read
            if (total > most) return null
            out.write(buffer, 0, read)
            read = read(buffer)
        }
    }
    return total
}

/** Providers are other apps, and fail with whatever exception they fail with. */
fun <T> provided(ask: () -> T): T = try {
    ask()
} catch (e: RuntimeException) {
    throw IOException(e)
}

private const val BUFFER_BYTES = 1 shl 14
