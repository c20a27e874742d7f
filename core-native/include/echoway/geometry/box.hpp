#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "echoway/geometry/segment.hpp"
#include "echoway/geometry/vec2.hpp"

namespace echoway {

/// The axis-parallel rectangle about some points, metres; without any, `low` lies above `high`.
struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(Vec2 p) noexcept {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// About closed loops such as Room::boundary.
[[nodiscard]] inline Box box_about(std::span<const std::vector<Vec2>> loops) noexcept {
  Box box;
  for (const std::vector<Vec2>& loop : loops) {
    for (const Vec2 p : loop) box.include(p);
  }
  return box;
}

/// About walls such as Room::walls.
[[nodiscard]] inline Box box_about(std::span<const Segment> walls) noexcept {
  Box box;
  for (const Segment& wall : walls) {
    box.include(wall.a);
    box.include(wall.b);
  }
  return box;
}

}  // namespace echoway
