#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace echoway::tools {

// What CLI11's own checks let through: nan is in every range, -1 a huge seed, 0x1p3 and true are numbers. Options hold
// numbers as our files do (echoway/text/number.hpp).

/// A decimal number from `low` to `high`.
[[nodiscard]] CLI::Validator decimal(double low, double high);
/// A whole decimal number from `low` to `high`.
[[nodiscard]] CLI::Validator whole(std::uint64_t low, std::uint64_t high = UINT64_MAX);
/// Anything but nothing: an empty path or name is a slip of a script.
[[nodiscard]] CLI::Validator not_empty();

}  // namespace echoway::tools
