package org.echoway.app.ui.common

import kotlinx.coroutines.flow.SharingStarted

private const val STOP_AFTER_MS = 5_000L

/** While a screen shows a state it is kept up to date, and a little longer: the phone may only be turned. */
internal val WHILE_SHOWN: SharingStarted = SharingStarted.WhileSubscribed(STOP_AFTER_MS)
