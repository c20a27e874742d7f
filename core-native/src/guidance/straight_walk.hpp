#pragma once

#include <optional>

#include "echoway/geometry/pose2.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// A straight walk from a pose, through a doorway if one lies on it.
class StraightWalk {
 public:
  /// `body_m`: how near to a wall ahead they come at most.
  StraightWalk(const Router& router, RoomIndex room, const Pose2& from, double body_m) noexcept;

  struct Place {
    RoomIndex room = kNoRoom;
    Pose2 pose{};  ///< In the frame of `room`.
  };
  /// Where they are after `on` metres, or before the wall that stops them sooner.
  [[nodiscard]] Place after(double on) const noexcept;

 private:
  RoomIndex room_;
  Pose2 from_;
  double until_wall_;
  struct Beyond {
    double on = 0.0;  ///< To the doorway.
    Place in{};       ///< In it, in the next room's frame.
    double until_wall = 0.0;
  };
  std::optional<Beyond> beyond_;
};

}  // namespace echoway::guidance
