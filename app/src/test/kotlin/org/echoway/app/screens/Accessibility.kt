package org.echoway.app.screens

import android.graphics.Bitmap
import android.graphics.Canvas
import android.view.View
import androidx.compose.ui.platform.ViewRootForTest
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.SemanticsNodeInteraction
import androidx.compose.ui.test.SemanticsNodeInteractionsProvider
import androidx.compose.ui.test.isRoot
import androidx.compose.ui.test.onLast
import androidx.compose.ui.text.TextLayoutResult
import com.google.android.apps.common.testing.accessibility.framework.AccessibilityCheckPreset
import com.google.android.apps.common.testing.accessibility.framework.AccessibilityCheckResult.AccessibilityCheckResultType
import com.google.android.apps.common.testing.accessibility.framework.AccessibilityHierarchyCheckResult
import com.google.android.apps.common.testing.accessibility.framework.Parameters
import com.google.android.apps.common.testing.accessibility.framework.checks.RedundantDescriptionCheck
import com.google.android.apps.common.testing.accessibility.framework.checks.TextContrastCheck
import com.google.android.apps.common.testing.accessibility.framework.uielement.AccessibilityHierarchyAndroid
import com.google.android.apps.common.testing.accessibility.framework.utils.contrast.BitmapImage
import org.junit.Assert.assertEquals

/**
 * Asserts what every screen owes a wearer who touches without looking, or reads with little sight: everything has a
 * name, nothing that is touched is below 48 dp, text stands out from its ground, no text is cut, and the screen's
 * heading is what a reader comes to first.
 */
fun SemanticsNodeInteractionsProvider.assertAccessible() {
    val root = onTopWindow().fetchSemanticsNode()
    val problems = frameworkProblems((root.root as ViewRootForTest).view) + textProblems(root) + headingProblems(root)
    assertEquals("accessibility", "", problems.joinToString("\n"))
}

/** The dialog where one is open, else the screen. */
fun SemanticsNodeInteractionsProvider.onTopWindow(): SemanticsNodeInteraction = onAllNodes(isRoot()).onLast()

/** What a screen reader says when one swipes through the screen: a line a stop, in order. */
fun SemanticsNodeInteractionsProvider.spokenLines(): List<String> =
    onTopWindow()
        .fetchSemanticsNode()
        .stops()
        .map { node -> (listOf(node.said) + listOfNotNull(node.stateSaid)).joinToString(", ") }

private fun frameworkProblems(view: View): List<String> {
    val node = view.createAccessibilityNodeInfo()
    node.setQueryFromAppProcessEnabled(view, true)
    val hierarchy = AccessibilityHierarchyAndroid.newBuilder(node, view.context).build()
    val parameters = Parameters().apply {
        putScreenCapture(BitmapImage(picture(view)))
        putCustomTouchTargetSize(48)
    }
    return AccessibilityCheckPreset.getAccessibilityHierarchyChecksForPreset(AccessibilityCheckPreset.LATEST)
        .filterNot { it is RedundantDescriptionCheck } // its list of words is missing from the published archive
        .flatMap { it.runCheckOnHierarchy(hierarchy, null, parameters) }
        // The edge of what scrolls cuts letters through, and what is left of them has no colour of its own.
        .filterNot {
            it.sourceCheckClass == TextContrastCheck::class.java && PARTLY_SEEN.any { key ->
                it.metadata?.getBoolean(key, false) == true
            }
        }
        .filter { it.type == AccessibilityCheckResultType.ERROR || it.type == AccessibilityCheckResultType.WARNING }
        .map(::told)
}

private val PARTLY_SEEN =
    listOf(TextContrastCheck.KEY_IS_AGAINST_SCROLLABLE_EDGE, TextContrastCheck.KEY_IS_POTENTIALLY_OBSCURED)

private fun told(result: AccessibilityHierarchyCheckResult): String {
    val element = result.element
    val name = element?.contentDescription ?: element?.text ?: element?.className
    val check = "${result.sourceCheckClass.simpleName} ${result.resultId}"
    return "$check: $name ${element?.boundsInScreen} ${result.metadata}"
}

private fun picture(view: View): Bitmap =
    Bitmap.createBitmap(view.width, view.height, Bitmap.Config.ARGB_8888).also { view.draw(Canvas(it)) }

/** Text that is cut, in its own line or by what holds it. What scrolls may reach beyond the screen. */
private fun textProblems(root: SemanticsNode): List<String> = root.descendants().mapNotNull { node ->
    val layouts = mutableListOf<TextLayoutResult>()
    node.config.getOrNull(SemanticsActions.GetTextLayoutResult)?.action?.invoke(layouts) ?: return@mapNotNull null
    val clipped = !node.scrolls() &&
        (node.boundsInRoot.width < node.size.width - 1 || node.boundsInRoot.height < node.size.height - 1)
    val words = node.config.getOrNull(SemanticsProperties.Text)?.joinToString()
    when {
        layouts.any(::overflows) -> "text overflows: $words"
        clipped -> "text is cut: $words ${node.boundsInRoot} of ${node.size}"
        else -> null
    }
}

/** Sizes are whole pixels and paragraphs are not; the rest of a pixel is no loss. */
private fun overflows(layout: TextLayoutResult): Boolean {
    val widest = (0 until layout.lineCount).maxOf { layout.getLineRight(it) - layout.getLineLeft(it) }
    return layout.multiParagraph.didExceedMaxLines || layout.multiParagraph.height > layout.size.height + 1 ||
        widest > layout.size.width + 1
}

private fun headingProblems(root: SemanticsNode): List<String> {
    val first = root.stops().firstOrNull() ?: return listOf("nothing to read")
    val heading = first.descendants().any { SemanticsProperties.Heading in it.config }
    return if (heading) emptyList() else listOf("a reader comes to \"${first.said}\" before any heading")
}

private fun SemanticsNode.descendants(): List<SemanticsNode> = listOf(this) + children.flatMap { it.descendants() }

private fun SemanticsNode.scrolls(): Boolean =
    SemanticsActions.ScrollBy in config || parent?.scrolls() == true

/** Where a screen reader stops: merged nodes that have something to say. */
private fun SemanticsNode.stops(): List<SemanticsNode> {
    val own = if (said.isNotEmpty()) listOf(this) else emptyList()
    return own + children.sortedBy { it.config.getOrNull(SemanticsProperties.TraversalIndex) ?: 0f }
        .flatMap { it.stops() }
}

private val SemanticsNode.said: String
    get() = config.getOrNull(SemanticsProperties.ContentDescription)?.joinToString()
        ?: config.getOrNull(SemanticsProperties.Text)?.joinToString { it.text }
        ?: ""

private val SemanticsNode.stateSaid: String?
    get() = config.getOrNull(SemanticsProperties.StateDescription)
        ?: config.getOrNull(SemanticsProperties.Selected)?.takeIf { it }?.let { "selected" }
        ?: config.getOrNull(SemanticsProperties.ToggleableState)?.name?.lowercase()
