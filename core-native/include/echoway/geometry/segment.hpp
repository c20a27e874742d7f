#pragma once

#include <algorithm>

#include "echoway/geometry/vec2.hpp"

namespace echoway {

/// A straight piece from `a` to `b`, metres.
struct Segment {
  Vec2 a{};
  Vec2 b{};

  friend constexpr bool operator==(const Segment&, const Segment&) = default;
  [[nodiscard]] constexpr Vec2 direction() const noexcept { return b - a; }
  [[nodiscard]] double length() const noexcept { return distance(a, b); }
};

/// Parameter in [0, 1] of the point of `s` nearest to `p`; 0 for a segment without length.
[[nodiscard]] constexpr double nearest_parameter(const Segment& s, Vec2 p) noexcept {
  const double length2 = squared_norm(s.direction());
  if (!(length2 > 0.0)) return 0.0;
  return std::clamp(dot(p - s.a, s.direction()) / length2, 0.0, 1.0);
}

[[nodiscard]] constexpr Vec2 nearest_point(const Segment& s, Vec2 p) noexcept {
  return s.a + nearest_parameter(s, p) * s.direction();
}

[[nodiscard]] inline double distance(const Segment& s, Vec2 p) noexcept { return distance(nearest_point(s, p), p); }

}  // namespace echoway
