package org.echoway.app.service

import android.app.Application
import android.content.Context
import java.io.File
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import org.echoway.app.AppContainer
import org.echoway.app.Clock
import org.echoway.app.ContainerOwner
import org.echoway.app.belt.BeltSource
import org.echoway.app.building.BuildingLibrary
import org.echoway.app.building.BundledBuildings
import org.echoway.app.control.Lookout
import org.echoway.app.control.Presence
import org.echoway.app.engine.Navigator
import org.echoway.app.guide.Guide
import org.echoway.app.guide.SpeechQueue
import org.echoway.app.guide.Wording
import org.echoway.app.motion.MotionSource
import org.echoway.app.recording.Recordings
import org.echoway.app.settings.Settings
import org.echoway.app.settings.SourceKind
import org.echoway.app.testing.MemorySettings
import org.echoway.app.testing.RecordingBuzzer
import org.echoway.app.testing.RecordingSiren
import org.echoway.app.testing.RecordingVoice
import org.echoway.app.testing.ScriptedBelt
import kotlinx.coroutines.flow.emptyFlow

/** An app whose belt, voice and vibrator are the test's; the rest is real. Everything runs on the main thread. */
class TestApp : Application(), ContainerOwner {
    override val container by lazy { TestContainer(this) }
}

class TestContainer(context: Context) : AppContainer {
    override val clock = Clock.SYSTEM
    override val settings =
        MemorySettings(Settings(building = "torgersen-lab", source = SourceKind.SIMULATED_WALK, introduced = true))
    override val buildings = BuildingLibrary.on(context, BundledBuildings(context, 1))
    override val navigator = Navigator(Dispatchers.Main, clock)
    override val voice = RecordingVoice(clock)
    override val buzzer = RecordingBuzzer()
    override val speech = SpeechQueue(voice, clock, MainScope())
    override val guide = Guide({ Wording.of(context, it) }, speech, buzzer, navigator, clock).also { guide ->
        MainScope().launch { guide.follow(settings.settings) }
    }
    val siren = RecordingSiren()
    override val lookout = Lookout(siren, clock, guide::tell)
    override val presence = Presence {}
    override val motion = MotionSource { emptyFlow() }
    override val recordings = Recordings(File(context.filesDir, "recordings"))
    override val cacheDir: File = context.cacheDir
    var belt = ScriptedBelt(bringsMotion = false)

    /** In place of [belt]. */
    var otherBelt: BeltSource? = null

    override fun hasSimulatedWalk(building: String) = building == "torgersen-lab"

    override fun beltSource(settings: Settings): BeltSource = otherBelt ?: belt
}
