package org.echoway.app.testing

import androidx.core.content.FileProvider
import org.robolectric.util.ReflectionHelpers

/** The provider of shared files remembers where files lie; every test has its files elsewhere. */
fun forgetSharedFolders() =
    ReflectionHelpers.getStaticField<MutableMap<*, *>>(FileProvider::class.java, "sCache").clear()
