#pragma once

#include <optional>
#include <string_view>

namespace echoway::text {

/// The finite decimal number that `token` spells as a whole (`-12.5`, `3e-2`), whatever the process's locale; nothing
/// for anything else: blanks, trailing characters, hexadecimal, `nan`, `inf`, or a value too large for a double.
[[nodiscard]] std::optional<double> parse_number(std::string_view token) noexcept;

/// The decimal integer that `token` spells as a whole, with an optional sign; nothing when it does not fit.
[[nodiscard]] std::optional<long long> parse_integer(std::string_view token) noexcept;

}  // namespace echoway::text
