#pragma once

#include <vector>

#include "echoway/building/building.hpp"

namespace echoway::thesis {

/// The thesis's inclusion test (section 5.1): a horizontal line from a point meets the walls an odd number of times
/// when the point is in the room. Uses the room's boundary, so that free-standing screens do not count; a room without
/// one is taken by its walls.
class Floor {
 public:
  explicit Floor(const Room& room);

  /// Each vertex belongs to the wall above it only, so that a line through one is counted right.
  [[nodiscard]] bool contains(Vec2 point) const noexcept;

  /// A frame along the floor's first side; a grid laid out in it turns with the map.
  [[nodiscard]] const Pose2& frame() const noexcept { return frame_; }
  [[nodiscard]] Vec2 low() const noexcept { return low_; }    ///< Corners of the bounding box in that frame; both the
  [[nodiscard]] Vec2 high() const noexcept { return high_; }  ///< origin when there are no walls.

 private:
  void add(Vec2 a, Vec2 b);
  void measure() noexcept;

  std::vector<Segment> sides_;
  Pose2 frame_{};
  Vec2 low_{};
  Vec2 high_{};
};

}  // namespace echoway::thesis
