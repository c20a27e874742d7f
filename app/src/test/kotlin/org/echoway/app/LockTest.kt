package org.echoway.app

import java.io.File
import org.junit.Assert.assertEquals
import org.junit.Test

/** The lock of the build without an Android SDK says what Gradle's catalog says. */
class LockTest {
    private val gradle = File(System.getProperty("echoway.root")!!, "gradle")
    private val catalog = File(gradle, "libs.versions.toml").readLines()
    private val versions = catalog.mapNotNull { Regex("(\\w+) = \"([^\"]+)\"").matchEntire(it) }
        .associate { it.groupValues[1] to it.groupValues[2] }
    private val lock = File(gradle, "sdkless.lock").readLines()

    /** Versions of a module or of its variant for the phone, in a section of the lock. */
    private fun locked(section: String, module: String): List<String> {
        val lines = lock.dropWhile { it != "[$section]" }.drop(1).takeWhile { it.isNotEmpty() }
        return listOf(module, "$module-android", "$module-jvm")
            .flatMap { name ->
                lines.filter { it.startsWith("$name:") }.map { it.removePrefix("$name:").substringBefore('@') }
            }
            .distinct()
    }

    private fun sections(alias: String) =
        if (alias.startsWith("sdkless-")) listOf(alias.split('-')[1]) else listOf("app", "test")

    @Test fun everyLibraryIsLockedAtTheVersionOfTheCatalog() {
        val entry = Regex("([\\w-]+) = \\{ module = \"([^\"]+)\", version.ref = \"(\\w+)\" \\}")
        val libraries = catalog.mapNotNull(entry::matchEntire).filter { it.groupValues[1] !in NOT_LOCKED }
        val wrong = libraries.mapNotNull { match ->
            val (alias, module, reference) = match.destructured
            val found = sections(alias).flatMap { locked(it, module) }.distinct()
            if (found == listOf(versions.getValue(reference))) {
                null
            } else {
                "$alias: catalog ${versions[reference]}, lock $found"
            }
        }
        assertEquals("run make update-lock", emptyList<String>(), wrong)
        assertEquals(
            "entries that the pattern understands",
            catalog.count { "module = " in it },
            libraries.size + NOT_LOCKED.size,
        )
    }

    private companion object {
        /** Served by another repository, which only the Gradle build reads. */
        val NOT_LOCKED = setOf("usb-serial")
    }
}
