#include "text/utf8.hpp"

#include <cstdint>

namespace echoway::text {
namespace {

/// Length in bytes of the well-formed character at the start of `s`, 0 when there is none.
std::size_t character_length(std::string_view s) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(s[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || s.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) > 0x9F;
  const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

bool is_utf8(std::string_view s) noexcept {
  while (!s.empty()) {
    const std::size_t length = character_length(s);
    if (length == 0) return false;
    s.remove_prefix(length);
  }
  return true;
}

std::string to_utf8(std::string_view s) {
  std::string out;
  while (!s.empty()) {
    const std::size_t length = character_length(s);
    if (length == 0) out += '?';
    out.append(s.substr(0, length));
    s.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace echoway::text
