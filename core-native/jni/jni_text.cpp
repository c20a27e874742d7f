#include "jni_text.hpp"

#include <cstdint>
#include <vector>

namespace echoway::jni {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

void append_utf8(std::string& out, char32_t c) {
  const auto tail = [&](int shift) { out.push_back(static_cast<char>(0x80 | ((c >> shift) & 0x3F))); };
  if (c < 0x80) {
    out.push_back(static_cast<char>(c));
  } else if (c < 0x800) {
    out.push_back(static_cast<char>(0xC0 | (c >> 6)));
    tail(0);
  } else if (c < 0x10000) {
    out.push_back(static_cast<char>(0xE0 | (c >> 12)));
    tail(6);
    tail(0);
  } else {
    out.push_back(static_cast<char>(0xF0 | (c >> 18)));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// Reads one code point and moves `i` behind it.
char32_t next_code_point(std::string_view utf8, std::size_t& i) {
  const auto first = static_cast<unsigned char>(utf8[i++]);
  if (first < 0x80) return first;
  const int tails = first >= 0xF0 && first < 0xF8 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  if (tails == 0 || first >= 0xF8) return kReplacement;
  char32_t c = first & (0x3F >> tails);
  for (int t = 0; t < tails; ++t) {
    if (i >= utf8.size() || (static_cast<unsigned char>(utf8[i]) & 0xC0) != 0x80) return kReplacement;
    c = (c << 6) | (static_cast<unsigned char>(utf8[i++]) & 0x3F);
  }
  const bool surrogate = c >= 0xD800 && c < 0xE000;
  return c > 0x10FFFF || surrogate ? kReplacement : c;
}

}  // namespace

std::string to_utf8(JNIEnv* env, jstring text) {
  if (text == nullptr) return {};
  const jsize length = env->GetStringLength(text);
  std::vector<jchar> units(static_cast<std::size_t>(length));
  env->GetStringRegion(text, 0, length, units.data());
  std::string out;
  out.reserve(units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    const char32_t unit = units[i];
    const bool high = unit >= 0xD800 && unit < 0xDC00;
    const bool paired = high && i + 1 < units.size() && units[i + 1] >= 0xDC00 && units[i + 1] < 0xE000;
    if (paired) {
      append_utf8(out, 0x10000 + ((unit - 0xD800) << 10) + (static_cast<char32_t>(units[++i]) - 0xDC00));
    } else {
      append_utf8(out, unit >= 0xD800 && unit < 0xE000 ? kReplacement : unit);
    }
  }
  return out;
}

jstring to_java(JNIEnv* env, std::string_view utf8) {
  std::vector<jchar> units;
  units.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t c = next_code_point(utf8, i);
    if (c < 0x10000) {
      units.push_back(static_cast<jchar>(c));
    } else {
      units.push_back(static_cast<jchar>(0xD800 + ((c - 0x10000) >> 10)));
      units.push_back(static_cast<jchar>(0xDC00 + ((c - 0x10000) & 0x3FF)));
    }
  }
  return env->NewString(units.data(), static_cast<jsize>(units.size()));
}

}  // namespace echoway::jni
