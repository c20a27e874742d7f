#pragma once

#include <span>
#include <vector>

#include "echoway/geometry/vec2.hpp"

namespace echoway {

/// Whether two floors (closed loops, holes included, in one frame) share ground deeper than `tolerance`: some point
/// lies inside both and farther than that from the walls of one of them. Floors that only touch do not.
[[nodiscard]] bool floors_overlap(std::span<const std::vector<Vec2>> a, std::span<const std::vector<Vec2>> b,
                                  double tolerance);

/// A point inside a floor, well off its walls.
[[nodiscard]] Vec2 interior_point(std::span<const std::vector<Vec2>> floor);

}  // namespace echoway
