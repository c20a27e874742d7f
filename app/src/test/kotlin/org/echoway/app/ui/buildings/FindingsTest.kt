package org.echoway.app.ui.buildings

import androidx.compose.foundation.layout.Column
import androidx.compose.ui.test.junit4.v2.createComposeRule
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import org.echoway.app.screens.spokenLines
import org.echoway.core.BuildingCheck
import org.echoway.core.Finding
import org.echoway.core.FindingKind
import org.echoway.core.Severity
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.rules.TemporaryFolder
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** What the core finds in a building, as a screen reader says it. */
@RunWith(AndroidJUnit4::class)
class FindingsTest {
    @get:Rule(order = 0) val temporary = TemporaryFolder()

    @get:Rule(order = 1) val rule = createComposeRule()

    /** Two rooms; the door between them is in the middle of one and names a third. */
    private fun found(): List<Finding> {
        File(System.getProperty("echoway.root")!!, "maps/two-rooms").listFiles()!!.forEach {
            it.copyTo(File(temporary.root, it.name))
        }
        File(temporary.root, "building.cfg").appendText("\nexit nowhere 1 1\n")
        return BuildingCheck.of(temporary.root)
            .findings.map { it.copy(file = File(it.file).name) }
            .filter { it.kind == FindingKind.UNKNOWN_ROOM }
    }

    /** Each of [lists] as of a building of its own. */
    private fun said(vararg lists: List<Finding>): List<String> {
        rule.setContent { Column { lists.forEach { Findings(it) } } }
        return rule.spokenLines()
    }

    private fun assertSays(words: String, detail: String) {
        val finding = found().single()
        assertEquals(
            listOf("$words, $detail${finding.problem}"),
            said(listOf(finding)).map { it.replace("${finding.line}", "N") },
        )
        assertTrue(finding.problem, "nowhere" in finding.problem)
    }

    @Test fun inEnglish() =
        assertSays("Warning, building.cfg, line N: A room is named that is not there.", "In detail: ")

    @Test
    @Config(qualifiers = "de")
    fun inGerman() = assertSays(
        "Warnung, building.cfg, Zeile N: Ein Raum wird genannt, den es nicht gibt.",
        "Genauer, auf Englisch: ",
    )

    @Test
    @Config(qualifiers = "fr")
    fun inFrench() =
        assertSays(
            "Avertissement, building.cfg, ligne N : Une pièce est nommée qui n'existe pas.",
            "Plus précisément, en anglais : ",
        )

    @Test fun everyKindHasItsOwnWords() {
        val each = FindingKind.entries.map { Finding(Severity.WARNING, it, "a", null, "") }
        assertEquals(each.size, said(*each.chunked(20).toTypedArray()).toSet().size)
    }

    @Test fun manyAreCutShort() {
        val many = List(23) { Finding(Severity.WARNING, FindingKind.NAME, "a", it + 1, "b") }
        assertEquals("And 3 more.", said(many).last())
    }
}
