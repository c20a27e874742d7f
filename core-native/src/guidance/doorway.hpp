#pragma once

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
  [[nodiscard]] static std::optional<Doorway> of(const Router& router, RoomIndex room, std::int32_t door, double body_m) noexcept;

  /// Whether a wearer may go straight from `from` to `to`, which lies beyond: not too slantwise, so that the far jamb does
  /// not come near. `begun`: they do so already, which is given up late.
  [[nodiscard]] bool lets_through(Vec2 from, Vec2 to, bool begun) const noexcept;

  /// Close before it and beside its middle: where to head for straight at the middle and on, if the frame leaves room for
  /// that. `sigma_m`: of the pose's position.
  [[nodiscard]] std::optional<Vec2> slant(const Pose2& pose, double sigma_m, bool begun) const noexcept;

 private:
  Doorway(const Passage& passage, double width, double body_m) : passage_(passage), width_(width), body_m_(body_m) {}
  /// Metres from the door's wall,
  [[nodiscard]] double before(Vec2 at) const noexcept { return dot(at - passage_.centre, passage_.inward); }
  /// and from its axis.
  [[nodiscard]] double aside(Vec2 at) const noexcept;

  Passage passage_;
  double width_;
  double body_m_;
};

}  // namespace echoway::guidance
