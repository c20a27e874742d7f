package org.echoway.core

/** Whether one place explains the echoes. */
enum class TrackState { SEARCHING, TRACKING, LOST }
