package org.echoway.app.ui.firstrun

import android.content.res.Resources
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.launch
import org.echoway.app.AppContainer
import org.echoway.app.R
import org.echoway.app.settings.SourceKind

/** The steps of the first run, in their order. */
enum class FirstRunStep(val title: Int, val words: Int) {
    BELT(R.string.intro_belt_title, R.string.intro_belt),
    FRONT(R.string.intro_front_title, R.string.intro_front),
    PRACTICE(R.string.intro_practice_title, R.string.intro_practice),
}

/**
 * Explains itself aloud, step by step; every step can be heard again, and all can be skipped.
 *
 * @param readerFirstMs how long a screen reader speaks first, when a step comes up; 0 without one
 */
class FirstRunViewModel(
    private val container: AppContainer,
    private val resources: Resources,
    private val readerFirstMs: Long = 0,
) : ViewModel() {
    private var explaining: Job? = null
    private val shown = MutableStateFlow(FirstRunStep.BELT)
    val step: StateFlow<FirstRunStep> = shown.asStateFlow()

    init {
        say(resources.getString(R.string.intro_hello), resources.getString(FirstRunStep.BELT.words))
    }

    fun again() = say(resources.getString(shown.value.words))

    fun next() = show(FirstRunStep.entries[(shown.value.ordinal + 1).coerceAtMost(FirstRunStep.entries.lastIndex)])

    fun back() = show(FirstRunStep.entries[(shown.value.ordinal - 1).coerceAtLeast(0)])

    fun skip(then: () -> Unit) = finish(then)

    /**
     * Chooses the walk that comes with the app, then [start]s guidance: only now does the phone ask for permissions.
     */
    fun practise(start: () -> Unit) {
        viewModelScope.launch {
            val building = container.buildings.all().firstOrNull { container.hasSimulatedWalk(it.id) }
            if (building != null) {
                container.settings.update {
                    it.copy(building = building.id, entrance = null, source = SourceKind.SIMULATED_WALK)
                }
            }
            finish(start)
        }
    }

    private fun finish(then: () -> Unit) {
        explaining?.cancel()
        container.guide.hush()
        viewModelScope.launch {
            container.settings.update { it.copy(introduced = true) }
            then()
        }
    }

    /** Left without a word: the voice must not go on explaining a screen that is gone. */
    override fun onCleared() = container.guide.hush()

    private fun show(step: FirstRunStep) {
        shown.value = step
        again()
    }

    private fun say(vararg lines: String) {
        explaining?.cancel()
        container.guide.hush()
        explaining = viewModelScope.launch {
            delay(readerFirstMs)
            container.guide.explain(lines.joinToString(" "))
        }
    }
}
