#pragma once

#include <vector>

#include "echoway/building/building.hpp"

namespace echoway::sim {

/// A door as one of its two rooms sees it; coordinates in that room's frame.
struct Doorway {
  std::size_t door = 0;  ///< Index into Building::doors.
  RoomIndex other = kNoRoom;
  std::size_t twin = 0;   ///< Index of the same door among the other room's doorways.
  Segment opening{};      ///< In this room's wall.
  Segment threshold{};    ///< In the middle of the wall's thickness: the same line for both rooms.
  Vec2 inward{0.0, 1.0};  ///< Unit normal of the wall, into this room.
  Pose2 other_frame{};    ///< The other room's frame, placed so that the two sides of the door coincide.

  [[nodiscard]] Vec2 centre() const noexcept { return 0.5 * (opening.a + opening.b); }
  /// Where one room ends and the other begins.
  [[nodiscard]] Vec2 middle() const noexcept { return 0.5 * (threshold.a + threshold.b); }
  [[nodiscard]] double width() const noexcept { return opening.length(); }
  /// Unit vector from opening.a to opening.b.
  [[nodiscard]] Vec2 along() const noexcept { return (1.0 / width()) * opening.direction(); }
};

/// The doorways of every room, index = room. A door that opens no wall on one of its sides is left out.
[[nodiscard]] std::vector<std::vector<Doorway>> find_doorways(const Building& building);

/// Of the floor within the room's boundary, square metres.
[[nodiscard]] double floor_area(const Room& room) noexcept;

}  // namespace echoway::sim
