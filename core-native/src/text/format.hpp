#pragma once

#include <string>

namespace echoway::text {

/// Appends `value` with at most `decimals` (0 ... 6) decimals, trailing zeros left out, always with a point.
/// REQUIRES: finite and |value| < kMaxWritable; anything else is written as 0, so writers check their input first.
void append_number(std::string& out, double value, int decimals);

/// The largest magnitude that append_number() writes.
inline constexpr double kMaxWritable = 1e12;

[[nodiscard]] bool is_writable(double value) noexcept;

/// `value` for a message to a person: at most two decimals, and that it is beyond kMaxWritable when it is.
[[nodiscard]] std::string brief(double value);

}  // namespace echoway::text
