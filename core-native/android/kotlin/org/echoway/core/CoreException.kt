package org.echoway.core

/** The core refused: an unusable building, a start that does not exist. The message says where and what to do. */
class CoreException(message: String) : Exception(message)
