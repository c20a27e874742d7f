#pragma once

#include <jni.h>

#include <string>
#include <string_view>

namespace echoway::jni {

/// Standard UTF-8, which JNI's own functions neither read nor write (they use a modified form). Ill-formed input
/// becomes U+FFFD.
std::string to_utf8(JNIEnv* env, jstring text);
jstring to_java(JNIEnv* env, std::string_view utf8);

}  // namespace echoway::jni
