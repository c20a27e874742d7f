package org.echoway.app.ui.diagnostics

import android.content.ClipData
import android.content.ClipboardManager
import android.content.Context
import android.os.Build
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.platform.LocalContext
import androidx.compose.ui.platform.LocalResources
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.navigation.NavGraphBuilder
import androidx.navigation.compose.composable
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.map
import org.echoway.app.AppContainer
import org.echoway.app.engine.NavigationState
import org.echoway.app.ui.Route
import org.echoway.core.BeltHealth

/** The diagnostics screen, and copying its report. */
fun NavGraphBuilder.diagnostics(container: AppContainer, back: () -> Unit) {
    composable<Route.Diagnostics> {
        val context = LocalContext.current
        val report = DiagnosticsReport(LocalResources.current)
        val health = remember {
            container.navigator.state.map { (it as? NavigationState.Running)?.belt ?: BeltHealth.NONE }
                .distinctUntilChanged()
                .conflate()
        }
        val belt by health.collectAsStateWithLifecycle(BeltHealth.NONE)
        DiagnosticsScreen(belt, onCopy = { context.copy(report.text(it, context.about())) }, onBack = back)
    }
}

private fun Context.copy(text: String) =
    getSystemService(ClipboardManager::class.java).setPrimaryClip(ClipData.newPlainText("Echoway", text))

private fun Context.about(): String {
    val version = packageManager.getPackageInfo(packageName, 0).versionName
    return "Echoway $version, Android ${Build.VERSION.RELEASE}, ${Build.MANUFACTURER} ${Build.MODEL}"
}
