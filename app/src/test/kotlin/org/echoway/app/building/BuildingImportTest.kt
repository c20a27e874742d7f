package org.echoway.app.building

import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.InputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import org.apache.commons.compress.archivers.zip.UnixStat
import org.apache.commons.compress.archivers.zip.ZipArchiveEntry
import org.apache.commons.compress.archivers.zip.ZipArchiveOutputStream
import org.echoway.core.PlanLoader
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith

/** What is picked may be good, broken or hostile; only the good is kept, and nothing else leaves a trace. */
@RunWith(AndroidJUnit4::class)
class BuildingImportTest {
    @get:Rule val temporary = TemporaryFolder()

    private val room = File(System.getProperty("echoway.root")!!, "maps/two-rooms")
    private val root get() = temporary.root
    private val home get() = File(root, "home")
    private val import get() = BuildingImport(home, File(root, "workshop"))

    /** A file that an archive must never reach. */
    private val treasure get() = File(root, "treasure")

    @Before fun hide() = treasure.writeText("untouched")

    private fun good(prefix: String = ""): Map<String, ByteArray> =
        room.listFiles()!!.filter { it.isFile }.associate { "$prefix${it.name}" to it.readBytes() }

    private fun zipped(files: Map<String, ByteArray>): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            for ((name, content) in files) {
                zip.putNextEntry(ZipEntry(name))
                zip.write(content)
            }
        }
        return bytes.toByteArray()
    }

    /** What a friendlier library refuses to write: the same name twice, links, names in other encodings. */
    private fun craft(encoding: String = "UTF-8", write: (ZipArchiveOutputStream) -> Unit): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipArchiveOutputStream(bytes).use {
            it.setEncoding(encoding)
            it.setUseLanguageEncodingFlag(false)
            write(it)
        }
        return bytes.toByteArray()
    }

    private fun ZipArchiveOutputStream.file(name: String, content: ByteArray, mode: Int? = null) {
        putArchiveEntry(ZipArchiveEntry(name).also { entry -> mode?.let { entry.unixMode = it } })
        write(content)
        closeArchiveEntry()
    }

    private fun take(archive: ByteArray, name: String = "Two rooms.zip") =
        import.zip(name) { ByteArrayInputStream(archive) }

    private fun assertRefused(problem: ImportProblem, archive: ByteArray) = assertRefused(problem) { take(archive) }

    private fun assertRefused(problem: ImportProblem, work: () -> Unit) {
        assertEquals(problem, assertThrows(ImportException::class.java) { work() }.problem)
        assertNothingLeft()
    }

    private fun assertNothingLeft() {
        assertEquals(listOf("treasure"), root.list()!!.toList() - "home")
        assertEquals(emptyList<String>(), home.list().orEmpty().toList())
        assertEquals("untouched", treasure.readText())
    }

    @Test fun aGoodArchiveBecomesABuildingThatTheCoreCanUse() {
        val imported = take(zipped(good()))
        assertEquals("two-rooms", imported.id)
        assertEquals(2, PlanLoader.load(File(home, imported.id)).rooms.size)
        assertFalse(File(root, "workshop").exists())
    }

    @Test fun theBuildingMayLieInAFolderOfTheArchive() {
        take(zipped(good("export/Two rooms/") + ("__MACOSX/export/._x" to ByteArray(3))))
        assertEquals(2, PlanLoader.load(File(home, "two-rooms")).rooms.size)
    }

    @Test fun theSameNameAgainGetsAnotherId() {
        take(zipped(good()))
        assertEquals("two-rooms-2", take(zipped(good())).id)
    }

    @Test fun aFolderIsTakenAsAnArchiveIs() {
        val files = object : BuildingFiles {
            override fun forEach(visit: (path: String, open: () -> InputStream) -> Unit) =
                good().forEach { (name, content) -> visit(name) { ByteArrayInputStream(content) } }
        }
        assertEquals("my-house", import.folder("My house", files).id)
    }

    @Test fun namesThatLeadOutAreRefused() {
        val unsafe = listOf(
            "../treasure", "a/../../treasure", "/treasure", "a//b", "..\\treasure", "C:\\treasure", "./building.cfg",
            "a\u0000b",
        )
        for (name in unsafe) {
            assertRefused(ImportProblem.UNSAFE_NAME, zipped(good() + (name to "stolen".toByteArray())))
        }
    }

    @Test fun linksAreRefused() = assertRefused(
        ImportProblem.UNSAFE_NAME,
        craft { zip ->
            good().forEach { (name, content) -> zip.file(name, content) }
            zip.file("room-link.room", "../../treasure".toByteArray(), UnixStat.LINK_FLAG or 511)
        },
    )

    @Test fun aBombIsRefusedWhateverItSaysOfItsSize() {
        val bomb = zipped(good() + ("room-big.room" to ByteArray(40 shl 20)))
        assertTrue("small as an archive", bomb.size < 1 shl 20)
        assertRefused(ImportProblem.TOO_LARGE, bomb)
        // The size in the directory is a lie: 1 byte.
        val uncompressedSize = bomb.indexOfLast("room-big.room".toByteArray()) - 46 + 24
        val lying =
            bomb.copyOf().also { it[uncompressedSize] = 1; (1..3).forEach { i -> it[uncompressedSize + i] = 0 } }
        assertRefused(ImportProblem.TOO_LARGE, lying)
    }

    private fun ByteArray.indexOfLast(part: ByteArray): Int =
        (size - part.size downTo 0).first { at -> part.indices.all { this[at + it] == part[it] } }

    @Test fun manyBombsCountTogether() = assertRefused(
        ImportProblem.TOO_LARGE, zipped((1..5).associate { "room-$it.room" to ByteArray(8 shl 20) }),
    )

    @Test fun aMillionFilesAreRefusedBeforeOneIsUnpacked() {
        val few = BuildingImport(home, File(root, "workshop"), ImportLimits(files = 100))
        assertRefused(ImportProblem.TOO_MANY_FILES) {
            few.zip("a") { ByteArrayInputStream(zipped((0..100).associate { "f$it" to ByteArray(0) })) }
        }
        val million = File(root, "million.zip")
        ZipOutputStream(million.outputStream().buffered()).use { zip ->
            repeat(1_000_000) { zip.putNextEntry(ZipEntry("$it")) }
        }
        val problem = assertThrows(ImportException::class.java) { import.zip("a") { million.inputStream() } }.problem
        million.delete()
        assertEquals(ImportProblem.TOO_LARGE, problem)
        assertNothingLeft()
    }

    /** All point to one file, and the archive says that it has one: listing them would take the phone's memory. */
    @Test fun aDirectoryOfHalfAMillionEntriesForOneFileIsRefused() {
        val honest = zipped(mapOf("a" to ByteArray(0)))
        val directory = honest.indexOfLast(byteArrayOf(0x50, 0x4B, 1, 2))
        val end = honest.indexOfLast(byteArrayOf(0x50, 0x4B, 5, 6))
        val hostile = ByteArrayOutputStream()
        hostile.write(honest, 0, directory)
        repeat(500_000) { hostile.write(honest, directory, end - directory) }
        hostile.write(honest, end, honest.size - end)
        assertTrue("not refused for its size", hostile.size() < ImportLimits().archiveBytes)
        assertRefused(ImportProblem.TOO_MANY_FILES, hostile.toByteArray())
    }

    @Test fun anArchiveWithAPasswordIsRefused() {
        val locked = zipped(good())
        // Bit 0 of an entry's flags: encrypted.
        for (at in 0..locked.size - 10) {
            if (locked[at] != 0x50.toByte() || locked[at + 1] != 0x4B.toByte()) continue
            val flags = mapOf(3 to 6, 1 to 8)[locked[at + 2].toInt()] ?: continue
            locked[at + flags] = (locked[at + flags].toInt() or 1).toByte()
        }
        assertRefused(ImportProblem.ENCRYPTED, locked)
    }

    @Test fun anEndlessStreamIsCutOff() {
        val endless = object : InputStream() {
            override fun read() = 0

            override fun read(b: ByteArray, off: Int, len: Int) = len
        }
        assertRefused(ImportProblem.TOO_LARGE) { import.zip("a") { endless } }
    }

    @Test fun namesInAnotherEncodingAreRefused() = assertRefused(
        ImportProblem.BAD_NAME,
        craft("CP437") { zip ->
            good().forEach { (name, content) -> zip.file(name, content) }
            zip.file("room-Büro.room", ByteArray(1))
        },
    )

    @Test fun theSameNameTwiceIsRefused() = assertRefused(
        ImportProblem.DUPLICATE_NAME,
        craft { zip ->
            good().forEach { (name, content) -> zip.file(name, content) }
            zip.file("building.cfg", "units m\n".toByteArray())
        },
    )

    @Test fun anArchiveThatIsCutShortIsRefusedWhereverItEnds() {
        val whole = zipped(good())
        for (length in listOf(0, 1, 30, whole.size / 2, whole.size - 1)) {
            assertRefused(ImportProblem.UNREADABLE, whole.copyOf(length))
        }
    }

    @Test fun bytesThatWereChangedAreRefused() {
        val whole = zipped(good())
        // The first file's packed content: its checksum does not fit any more.
        val broken = whole.copyOf().also { for (i in 60..75) it[i] = (it[i].toInt() xor 0x5A).toByte() }
        assertThrows(Exception::class.java) { take(broken) }
        assertNothingLeft()
    }

    @Test fun somethingElseThanAnArchiveIsRefused() =
        assertRefused(ImportProblem.UNREADABLE, "hello".repeat(100).toByteArray())

    @Test fun anArchiveWithoutABuildingIsRefused() =
        assertRefused(ImportProblem.NO_BUILDING, zipped(mapOf("readme.txt" to "hi".toByteArray())))

    @Test fun severalBuildingsAreRefused() =
        assertRefused(ImportProblem.SEVERAL_BUILDINGS, zipped(good("a/") + good("b/")))

    @Test fun whatTheCoreCannotUseIsRefusedWithItsFindings() {
        val bad = good() + ("room-office.room" to "1 0 0\n1 0 0 zero 1\n".toByteArray())
        val findings = assertThrows(UnusableBuilding::class.java) { take(zipped(bad)) }.findings
        assertTrue("$findings", findings.any { it.file == "room-office.room" })
        assertNothingLeft()
    }

    @Test fun whatAnEarlierAttemptLeftBehindIsSweptAway() {
        File(root, "workshop/unpacked").mkdirs()
        File(root, "workshop/unpacked/building.cfg").writeText("half")
        assertEquals("two-rooms", take(zipped(good())).id)
        assertFalse(File(root, "workshop").exists())
    }

    @Test fun aFullDiskIsToldAndLeavesNothing() {
        home.mkdirs()
        assertRefused(ImportProblem.DISK_FULL) {
            import.zip("a") { throw java.io.IOException("write failed: ENOSPC (No space left on device)") }
        }
    }
}
