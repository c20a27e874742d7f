package org.echoway.app

import android.Manifest
import android.content.Context
import android.content.pm.PackageManager
import android.hardware.SensorManager
import android.media.AudioManager
import android.os.Build
import android.os.Vibrator
import androidx.core.content.ContextCompat
import androidx.datastore.preferences.preferencesDataStoreFile
import java.io.File
import java.io.IOException
import java.util.concurrent.Executors
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.asCoroutineDispatcher
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.echoway.app.belt.AndroidUsbBus
import org.echoway.app.belt.BeltSource
import org.echoway.app.belt.ReplayedBelt
import org.echoway.app.belt.UsbBeltSource
import org.echoway.app.belt.UsbBus
import org.echoway.app.belt.WalkLog
import org.echoway.app.building.BuildingLibrary
import org.echoway.app.building.BundledBuildings
import org.echoway.app.control.Lookout
import org.echoway.app.control.MomentOfSilence
import org.echoway.app.control.PhoneSiren
import org.echoway.app.control.Presence
import org.echoway.app.engine.Navigator
import org.echoway.app.guide.Guide
import org.echoway.app.guide.SpeechQueue
import org.echoway.app.guide.Wording
import org.echoway.app.motion.MotionSource
import org.echoway.app.motion.PhoneMotion
import org.echoway.app.motion.SwitchedMotion
import org.echoway.app.recording.Recordings
import org.echoway.app.settings.DataStoreSettings
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SettingsStore
import org.echoway.app.settings.SourceKind
import org.echoway.app.touch.Buzzer
import org.echoway.app.touch.PhoneBuzzer
import org.echoway.app.voice.PhoneAudioFocus
import org.echoway.app.voice.PhoneTones
import org.echoway.app.voice.TtsVoice
import org.echoway.app.voice.Voice
import org.echoway.app.voice.VoiceWithTones

/** The parts of the app, each made once and when first needed. Tests make their own. */
interface AppContainer {
    val clock: Clock
    val settings: SettingsStore
    val buildings: BuildingLibrary
    val navigator: Navigator
    val speech: SpeechQueue
    val guide: Guide
    val lookout: Lookout
    val presence: Presence
    val voice: Voice
    val buzzer: Buzzer
    val motion: MotionSource
    val recordings: Recordings
    val cacheDir: File

    fun hasSimulatedWalk(building: String): Boolean

    fun beltSource(settings: Settings): BeltSource
}

/** Whatever is not made for a test. */
open class PhoneContainer(private val context: Context) : AppContainer {
    override val clock: Clock get() = Clock.SYSTEM

    override val settings: SettingsStore by lazy {
        DataStoreSettings(DataStoreSettings.inFile { context.preferencesDataStoreFile("settings") })
    }

    override val buildings: BuildingLibrary by lazy {
        BuildingLibrary.on(context, BundledBuildings(context, installed()))
    }

    override val navigator by lazy {
        val core = Executors.newSingleThreadExecutor { Thread(it, "echoway-core") }
        Navigator(core.asCoroutineDispatcher(), clock)
    }

    override val speech by lazy { SpeechQueue(voice, clock, MainScope()) }

    override val guide by lazy {
        Guide({ Wording.of(context, it) }, speech, buzzer, navigator, clock).also { guide ->
            MainScope().launch { guide.follow(settings.settings) }
        }
    }

    override val lookout by lazy { Lookout(PhoneSiren(), clock, guide::tell) }

    override val presence: Presence get() = MomentOfSilence()

    override val voice: Voice by lazy {
        val focus = PhoneAudioFocus(context.getSystemService(AudioManager::class.java))
        VoiceWithTones(TtsVoice(context, focus), PhoneTones(focus))
    }

    override val buzzer: Buzzer by lazy { PhoneBuzzer(context.getSystemService(Vibrator::class.java)) }

    override val motion: MotionSource by lazy {
        val sensors = PhoneMotion(context.getSystemService(SensorManager::class.java), ::stepsAllowed)
        SwitchedMotion(sensors, settings.settings.map { it.motion })
    }

    override val recordings by lazy { Recordings(File(context.filesDir, "recordings")) }

    override val cacheDir: File get() = context.cacheDir

    override fun hasSimulatedWalk(building: String) = "$building.scans.csv" in context.assets.list(WALKS).orEmpty()

    protected open val usb: UsbBus by lazy { AndroidUsbBus(context) }

    override fun beltSource(settings: Settings): BeltSource = when (settings.source) {
        SourceKind.USB -> UsbBeltSource(usb, clock)
        SourceKind.SIMULATED_WALK -> ReplayedBelt(clock) { bundledWalk(settings.building) }
        SourceKind.RECORDING -> ReplayedBelt(clock) { recordedWalk(settings.recording) }
    }

    private suspend fun bundledWalk(building: String?) = withContext(Dispatchers.IO) {
        fun asset(kind: String) = context.assets.open("$WALKS/$building.$kind.csv").bufferedReader()
        WalkLog.read(asset("scans"), asset("motion"))
    }

    private suspend fun recordedWalk(name: String?) = withContext(Dispatchers.IO) {
        val file = recordings.folder.entry(name) ?: throw IOException("there is no such recording")
        val motion = File(file.parentFile, file.name.removeSuffix(Recordings.SCANS) + Recordings.MOTION)
        WalkLog.read(file.bufferedReader(), motion.takeIf { it.isFile && it != file }?.bufferedReader())
    }

    private fun stepsAllowed() = Build.VERSION.SDK_INT < Build.VERSION_CODES.Q ||
        ContextCompat.checkSelfPermission(
            context, Manifest.permission.ACTIVITY_RECOGNITION,
        ) == PackageManager.PERMISSION_GRANTED

    /** When this app was installed or updated last. Its version is no measure: one that is being worked on keeps it. */
    private fun installed(): Long = context.packageManager.getPackageInfo(context.packageName, 0).lastUpdateTime

    private companion object {
        const val WALKS = "walks"
    }
}
