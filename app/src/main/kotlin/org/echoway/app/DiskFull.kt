package org.echoway.app

import java.io.IOException

/** Whether a write failed for want of room. Streams of Android and of the JVM say so in their message alone. */
val IOException.isDiskFull: Boolean get() = message.orEmpty().let { "ENOSPC" in it || "No space left" in it }
