package org.echoway.app

import java.io.File
import javax.xml.parsers.DocumentBuilderFactory
import org.junit.Assert.assertEquals
import org.junit.Test
import org.w3c.dom.Element

/** Every word of the app is there in every language that the core speaks, with the same places to fill in. */
class LanguagesTest {
    private val resources = File(System.getProperty("echoway.root")!!, "app/src/main/res")

    /** Texts by name; a plural's and an array's items together under theirs. */
    private fun texts(folder: String): Map<String, List<String>> = File(resources, folder).listFiles().orEmpty()
        .filter { it.extension == "xml" }
        .flatMap { file ->
            val root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file).documentElement
            (0 until root.childNodes.length).mapNotNull { root.childNodes.item(it) as? Element }
        }
        .filter { it.tagName in KINDS && it.getAttribute("translatable") != "false" }
        .associate { it.getAttribute("name") to items(it) }

    private fun items(element: Element): List<String> {
        val items = element.getElementsByTagName("item")
        return if (items.length == 0) listOf(element.textContent) else (0 until items.length).map {
            items.item(it).textContent
        }
    }

    private fun places(texts: List<String>) = texts.flatMap { text -> PLACE.findAll(text).map { it.value } }.toSet()

    private fun inEveryLanguage(
        check: (language: String, english: Map<String, List<String>>, other: Map<String, List<String>>) -> Unit,
    ) {
        val english = texts("values")
        for (language in listOf("de", "fr")) check(language, english, texts("values-$language"))
    }

    @Test fun nothingIsMissingAndNothingIsLeftOver() = inEveryLanguage { language, english, other ->
        assertEquals("not in values-$language", emptySet<String>(), english.keys - other.keys)
        assertEquals("only in values-$language", emptySet<String>(), other.keys - english.keys)
    }

    @Test fun whatIsFilledInIsTheSame() = inEveryLanguage { language, english, other ->
        other.forEach { (name, texts) ->
            assertEquals("$name in $language", places(english.getValue(name)), places(texts))
        }
    }

    @Test fun arraysAreAsLong() {
        fun arrays(folder: String) = texts(folder).filterKeys { it == "sides" }.mapValues { it.value.size }
        inEveryLanguage { language, _, _ -> assertEquals(arrays("values"), arrays("values-$language")) }
    }

    private companion object {
        val KINDS = setOf("string", "plurals", "string-array")
        val PLACE = Regex("%\\d\\$[.\\d]*[sdf]")
    }
}
