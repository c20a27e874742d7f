package org.echoway.app

import java.io.File

/**
 * The file or folder of that [name] directly in this folder; null when there is none. A name that comes from outside,
 * as from settings, cannot lead anywhere else.
 */
internal fun File.entry(name: String?): File? = listFiles().orEmpty().firstOrNull { it.name == name }
