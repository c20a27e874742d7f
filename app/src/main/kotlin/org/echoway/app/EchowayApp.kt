package org.echoway.app

import android.app.Application
import android.content.Context

class EchowayApp : Application(), ContainerOwner {
    override val container: AppContainer by lazy { PhoneContainer(this) }
}

/** An application that has the app's parts; a test's application is another one. */
interface ContainerOwner {
    val container: AppContainer
}

val Context.container: AppContainer get() = (applicationContext as ContainerOwner).container
