#pragma once

#include <array>
#include <span>
#include <vector>

#include "echoway/geometry/segment.hpp"

namespace echoway::routing {

/// A turning point about a convex corner of an obstacle that is inflated by a radius.
struct TurningPoint {
  Vec2 position{};
  std::array<Vec2, 2> sides{};  ///< From `position` along the circumscribed polygon, clockwise and counter-clockwise.
};

/// Circumscribed turning points, at `radius`, about every convex corner and free end of `solids`. Ends nearer than a
/// few millimetres are taken for one corner, as hand-drawn plans need.
[[nodiscard]] std::vector<TurningPoint> turning_points(std::span<const Segment> solids, double radius);

/// True when a shortest way may turn at `point` while going along `direction`: the line does not enter the obstacle.
[[nodiscard]] bool is_taut(const std::array<Vec2, 2>& sides, Vec2 direction) noexcept;

}  // namespace echoway::routing
