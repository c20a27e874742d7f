package org.echoway.app.settings

import android.content.Context
import android.content.res.Configuration
import android.os.LocaleList
import java.util.Locale
import org.echoway.core.Language

/** This context with its resources in a language, or in the phone's own when it is null. */
fun Context.inLanguage(language: Language?): Context {
    if (language == null) return this
    val configuration = Configuration(resources.configuration)
    configuration.setLocales(LocaleList(Locale.forLanguageTag(language.tag)))
    return createConfigurationContext(configuration)
}
