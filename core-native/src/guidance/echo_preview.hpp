#pragma once

#include "echoway/building/building.hpp"
#include "echoway/routing/free_space.hpp"

namespace echoway::guidance {

/// The nearest mapped thing within a cone, metres from its tip, at most `limit`. Everything that could answer from
/// there at any angle: what is nearer than this is in no plan.
[[nodiscard]] double nearest_in_cone(const FreeSpace& space, Vec2 tip, double axis, double half_angle,
                                     double limit) noexcept;

/// What one sensor would hear: the nearest wall met squarely, right-angled corner or all-reflective element within the
/// beam, metres from the face; `limit` when nothing answers. Good enough to compare two places with each other.
[[nodiscard]] double preview_range(const Room& room, const FreeSpace& space, Vec2 face, double axis, double half_beam,
                                   double limit) noexcept;

}  // namespace echoway::guidance
