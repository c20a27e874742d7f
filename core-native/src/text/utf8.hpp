#pragma once

#include <string>
#include <string_view>

namespace echoway::text {

/// Well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, at most U+10FFFF).
[[nodiscard]] bool is_utf8(std::string_view s) noexcept;

/// `s` with every byte that belongs to no well-formed character replaced by `?`.
[[nodiscard]] std::string to_utf8(std::string_view s);

}  // namespace echoway::text
