#pragma once

#include <cmath>
#include <optional>

#include "echoway/geometry/pose2.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Beside the middle of a doorway by this much still goes through, metres.
inline constexpr double kDoorMiss = 0.18;

/// A doorway that a wearer in one of its rooms is about to go through.
class Doorway {
 public:
  /// None when the door is not in a wall of that room.
  [[nodiscard]] static std::optional<Doorway> of(const Router& router, RoomIndex room, std::int32_t door,
                                                 double body_m) noexcept;

  /// Whether a wearer may go straight from `from` to `to`, which lies beyond: not too slantwise, so that the far jamb
  /// does not come near. `begun`: they do so already, which is given up late.
  [[nodiscard]] bool lets_through(Vec2 from, Vec2 to, bool begun) const noexcept;

  /// Close before it and beside its middle: where to head for straight at the middle and on, if the frame leaves room
  /// for that. `sigma_m`: of the pose's position.
  [[nodiscard]] std::optional<Vec2> slant(const Pose2& pose, double sigma_m, bool begun) const noexcept;

  [[nodiscard]] Vec2 centre() const noexcept { return passage_.centre; }
  [[nodiscard]] double width() const noexcept { return width_; }
  /// Which way leads through, as a unit vector and in radians; and along the wall that it is in.
  [[nodiscard]] Vec2 through() const noexcept { return -1.0 * passage_.inward; }
  [[nodiscard]] double axis() const noexcept { return std::atan2(-passage_.inward.y, -passage_.inward.x); }
  [[nodiscard]] Vec2 along() const noexcept { return perpendicular(passage_.inward); }
  /// Metres from that wall,
  [[nodiscard]] double before(Vec2 at) const noexcept { return dot(at - passage_.centre, passage_.inward); }
  /// and from the axis, positive towards `along`.
  [[nodiscard]] double beside(Vec2 at) const noexcept { return dot(at - passage_.centre, along()); }
  /// The same where somebody comes through the wall who goes from `from` to `ahead`, which leads there.
  [[nodiscard]] double crossing(Vec2 from, Vec2 ahead) const noexcept;

 private:
  Doorway(const Passage& passage, double width, double body_m) : passage_(passage), width_(width), body_m_(body_m) {}
  [[nodiscard]] double aside(Vec2 at) const noexcept { return std::abs(beside(at)); }

  Passage passage_;
  double width_;
  double body_m_;
};

}  // namespace echoway::guidance
