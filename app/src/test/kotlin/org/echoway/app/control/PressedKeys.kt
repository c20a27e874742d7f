package org.echoway.app.control

import android.content.Intent
import android.media.session.MediaSession as PlatformSession
import android.media.session.MediaSessionManager.RemoteUserInfo
import android.view.KeyEvent
import androidx.media3.session.MediaSession
import java.lang.reflect.Modifier
import org.robolectric.util.ReflectionHelpers
import org.robolectric.util.ReflectionHelpers.ClassParameter.from

/**
 * Presses a key as Android does: the system's session service hands the key event to the platform's session that Media3
 * keeps inside its own. (Which app's session the system chooses is the system's.)
 */
internal fun MediaSession.press(keyCode: Int) {
    val system = RemoteUserInfo("android", 1, 1000)
    for (action in listOf(KeyEvent.ACTION_DOWN, KeyEvent.ACTION_UP)) {
        val intent = Intent(Intent.ACTION_MEDIA_BUTTON).putExtra(Intent.EXTRA_KEY_EVENT, KeyEvent(action, keyCode))
        ReflectionHelpers.callInstanceMethod<Unit>(
            platformSession(this), "dispatchMediaButton", from(RemoteUserInfo::class.java, system),
            from(Intent::class.java, intent),
        )
    }
}

/** The sessions that this process has open. */
internal fun openSessions(): List<MediaSession> = MediaSession::class.java.declaredFields
    .filter { Modifier.isStatic(it.modifiers) && Map::class.java.isAssignableFrom(it.type) }
    .flatMap { it.isAccessible = true; (it.get(null) as Map<*, *>).values }
    .filterIsInstance<MediaSession>()

private fun platformSession(session: MediaSession): PlatformSession {
    val seen = mutableSetOf<Int>()
    val queue = ArrayDeque<Any>(listOf(session))
    while (queue.isNotEmpty()) {
        val next = queue.removeFirst()
        if (next is PlatformSession) return next
        if (seen.add(System.identityHashCode(next))) queue.addAll(fields(next))
    }
    throw AssertionError("Media3 keeps no platform session")
}

private fun fields(of: Any): List<Any> = generateSequence<Class<*>>(of.javaClass) { it.superclass }
    .takeWhile { it.name.startsWith("androidx.media3.session") }
    .flatMap { it.declaredFields.asSequence() }
    .filterNot { Modifier.isStatic(it.modifiers) || it.type.isPrimitive }
    .mapNotNull { it.isAccessible = true; it.get(of) }
    .toList()
