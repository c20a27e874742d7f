#pragma once

#include <cmath>

#include "echoway/geometry/vec2.hpp"
#include "echoway/units.hpp"

namespace echoway {

/// The angle in (-pi, pi] equal to `radians` modulo a full turn. Exact remainder, so that any finite number of turns
/// costs no more than the rounding of the input.
[[nodiscard]] inline double wrap_angle(double radians) noexcept {
  const double wrapped = std::remainder(radians, kTwoPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// A position and a heading in some frame, or the rigid transform that takes that heading's own frame into it.
/// Heading: radians, counter-clockwise from +x.
struct Pose2 {
  Vec2 position{};
  double heading = 0.0;

  friend constexpr bool operator==(const Pose2&, const Pose2&) = default;

  /// Takes a point from this pose's own frame into the frame in which the pose is given.
  [[nodiscard]] Vec2 transform(Vec2 local) const noexcept {
    const Vec2 e = unit_from_angle(heading);
    return {position.x + e.x * local.x - e.y * local.y, position.y + e.y * local.x + e.x * local.y};
  }

  /// The inverse of transform().
  [[nodiscard]] Vec2 inverse_transform(Vec2 outer) const noexcept {
    const Vec2 e = unit_from_angle(heading);
    return rotated(outer - position, {e.x, -e.y});
  }

  /// Composition: `(*this) * local`, heading wrapped.
  [[nodiscard]] Pose2 compose(const Pose2& local) const noexcept {
    return {transform(local.position), wrap_angle(heading + local.heading)};
  }

  /// The pose of `outer` seen from this pose: `this->compose(this->relative(outer)) == outer`.
  [[nodiscard]] Pose2 relative(const Pose2& outer) const noexcept {
    return {inverse_transform(outer.position), wrap_angle(outer.heading - heading)};
  }
};

[[nodiscard]] inline bool is_finite(const Pose2& pose) noexcept {
  return is_finite(pose.position) && std::isfinite(pose.heading);
}

}  // namespace echoway
