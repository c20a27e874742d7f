#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "echoway/geometry/segment.hpp"

namespace echoway {

/// Where a point lies with respect to a floor.
enum class Inclusion : std::uint8_t { outside, on_boundary, inside };

/// A point nearer than this to a wall of the boundary lies on it, metres. Well above the rounding of coordinates up to
/// 1e6 m, so that the even-odd count is never asked about a point that rounding could move across a wall.
inline constexpr double kOnBoundary = 1e-9;

/// Even-odd test (thesis section 5.1, figure 5.5) of `p` against closed loops such as Room::boundary; holes count as
/// outside. Half-open edges make a ray through a vertex count once. A point that is not finite is outside.
[[nodiscard]] inline Inclusion classify(std::span<const std::vector<Vec2>> loops, Vec2 p) noexcept {
  if (!is_finite(p)) return Inclusion::outside;
  bool inside = false;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2 a = loop[j];
      const Vec2 b = loop[i];
      const bool near_x = p.x >= std::min(a.x, b.x) - kOnBoundary && p.x <= std::max(a.x, b.x) + kOnBoundary;
      const bool near_y = p.y >= std::min(a.y, b.y) - kOnBoundary && p.y <= std::max(a.y, b.y) + kOnBoundary;
      if (near_x && near_y && distance(Segment{a, b}, p) <= kOnBoundary) return Inclusion::on_boundary;
      if ((a.y > p.y) == (b.y > p.y)) continue;
      // Left of the edge, whichever way it runs: the ray towards +x crosses it.
      if ((cross(b - a, p - a) > 0.0) == (b.y > a.y)) inside = !inside;
    }
  }
  return inside ? Inclusion::inside : Inclusion::outside;
}

/// Inside or on a wall.
[[nodiscard]] inline bool contains(std::span<const std::vector<Vec2>> loops, Vec2 p) noexcept {
  return classify(loops, p) != Inclusion::outside;
}

/// Twice-signed shoelace area halved, square metres; positive when counter-clockwise. Taken about the first vertex, so
/// that a loop far from the origin loses no digits.
[[nodiscard]] inline double signed_area(std::span<const Vec2> loop) noexcept {
  double twice = 0.0;
  for (std::size_t i = 2; i < loop.size(); ++i) twice += cross(loop[i - 1] - loop[0], loop[i] - loop[0]);
  return 0.5 * twice;
}

}  // namespace echoway
