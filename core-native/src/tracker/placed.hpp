#pragma once

#include "echoway/building/building.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// A room's frame in its level's, with what every particle in the room needs of it worked out once.
struct RoomFrame {
  RoomIndex room = kNoRoom;
  int level = 0;
  Pose2 pose{};
  Vec2 turn{1.0, 0.0};                             ///< cos, sin of its heading,
  double cos2 = 1.0, sin2 = 0.0, cos_sin = 0.0;    ///< and their products.

  RoomFrame() = default;
  RoomFrame(const Building& building, RoomIndex index) noexcept
      : room(index),
        level(building.room(index).level),
        pose(building.room(index).frame),
        turn(unit_from_angle(pose.heading)),
        cos2(turn.x * turn.x),
        sin2(turn.y * turn.y),
        cos_sin(turn.x * turn.y) {}
};

/// A place in its level's frame.
struct Placed {
  int level = 0;
  Vec2 position{};
  double heading = 0.0;
};

/// `position` and `heading` in the frame of the room.
[[nodiscard]] inline Placed place(Vec2 position, double heading, const RoomFrame& frame) noexcept {
  const Vec2 t = frame.turn;
  const Vec2 at{frame.pose.position.x + t.x * position.x - t.y * position.y,
                frame.pose.position.y + t.y * position.x + t.x * position.y};
  return {frame.level, at, heading + frame.pose.heading};
}

[[nodiscard]] inline Placed place(const Particle& p, const RoomFrame& frame) noexcept {
  return place(p.position, p.heading, frame);
}

}  // namespace echoway::tracker
