#pragma once

#include <vector>

#include "echoway/building/building.hpp"

namespace echoway::sim {

/// A door as one of its two rooms sees it; coordinates in that room's frame.
struct Doorway {
  std::size_t door = 0;    ///< Index into Building::doors.
  RoomIndex other = kNoRoom;
  std::size_t twin = 0;    ///< Index of the same door among the other room's doorways.
  Vec2 centre{};           ///< On this room's wall.
  Vec2 middle{};           ///< Of the passage, where one room ends and the other begins.
  Vec2 along{1.0, 0.0};    ///< Unit vector of the wall.
  Vec2 inward{0.0, 1.0};   ///< Unit normal, into this room.
  double width = 0.9;
  Pose2 other_frame{};     ///< The other room's frame, placed so that the two sides of the door coincide.

  /// In this room's wall.
  [[nodiscard]] Segment opening() const noexcept { return across(centre); }
  /// In the middle of the wall's thickness: the same line for both rooms.
  [[nodiscard]] Segment threshold() const noexcept { return across(middle); }

 private:
  [[nodiscard]] Segment across(Vec2 at) const noexcept {
    return {at - (0.5 * width) * along, at + (0.5 * width) * along};
  }
};

/// The doorways of every room, index = room.
[[nodiscard]] std::vector<std::vector<Doorway>> find_doorways(const Building& building);

/// Even-odd test against the room's boundary.
[[nodiscard]] bool inside(const Room& room, Vec2 p) noexcept;

/// Of the floor within the room's boundary, square metres.
[[nodiscard]] double floor_area(const Room& room) noexcept;

}  // namespace echoway::sim
