#pragma once

namespace echoway {

/// Whether a firmware's name may have this character: printable ASCII that means nothing to a sentence. Others are left
/// out, by whoever writes a sentence and by whoever reads one.
[[nodiscard]] constexpr bool may_stand_in_name(char c) noexcept {
  return c >= ' ' && c <= '~' && c != ',' && c != '*' && c != '$';
}

}  // namespace echoway
