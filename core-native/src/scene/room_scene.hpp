#pragma once

#include <vector>

#include "echoway/building/building.hpp"
#include "scene/reflector.hpp"

namespace echoway::scene {

/// An open door as one of its two rooms sees it.
struct Opening {
  RoomIndex to = kNoRoom;
  Vec2 centre{};              ///< In this room's frame.
  Vec2 tangent{};             ///< Unit, along the wall.
  double half_width = 0.0;
  double gap = 0.0;           ///< Thickness of the wall between the two rooms, metres.
  Vec2 rotation{1.0, 0.0};    ///< cos, sin of the turn from this room's frame into the neighbour's ...
  Vec2 shift{};               ///< ... and the shift that follows it.

  [[nodiscard]] Segment span() const noexcept { return {centre - half_width * tangent, centre + half_width * tangent}; }
  [[nodiscard]] Vec2 to_neighbour(Vec2 p) const noexcept { return rotated(p, rotation) + shift; }
};

/// A corner of the floor's boundary loops is `loop_begin`-indexed into `vertices`.
struct FloorLoops {
  std::vector<Vec2> vertices;
  std::vector<std::uint32_t> begin;  ///< Start of each loop, and one past the last.

  [[nodiscard]] bool contains(Vec2 p) const noexcept;
  [[nodiscard]] double distance(Vec2 p) const noexcept;  ///< To the nearest side.
  [[nodiscard]] bool crossed_by_box(Vec2 low, Vec2 high) const noexcept;
};

/// One room as the estimator needs it: everything that can echo at someone in this room, its own and what is seen
/// through its open doors, in the room's frame.
struct RoomScene {
  std::vector<Reflector> reflectors;
  std::vector<Segment> occluders;      ///< What blocks sight: walls cut at the doors, and all-reflective elements.
  std::vector<Opening> openings;
  FloorLoops floor;
  Vec2 low{};                          ///< Bounding box of the floor.
  Vec2 high{};
  std::uint32_t own_reflectors = 0;    ///< The first ones are the room's own; the others lie beyond doors.
  std::uint32_t own_occluders = 0;     ///< The same of these.
  std::uint32_t first_cell = 0;        ///< Of the grid over the bounding box.
  int columns = 0;
  int rows = 0;
  double cell_size = 0.0;
  double cells_per_metre = 0.0;
  Vec2 grid_origin{};

  /// Of the bounding box, square metres.
  [[nodiscard]] double box_area() const noexcept { return (high.x - low.x) * (high.y - low.y); }
};

/// Compiles the rooms of a building one by one, so that no more than one of them is held whole. Sound is followed
/// through at most two open doors and `max_range` metres.
class RoomCompiler {
 public:
  RoomCompiler(const Building& building, double max_range, double cell_size);

  [[nodiscard]] std::size_t rooms() const noexcept { return own_.size(); }
  [[nodiscard]] RoomScene compile(RoomIndex room) const;

 private:
  std::vector<RoomScene> own_;   ///< Without what lies beyond their doors.
  double max_range_;
};

}  // namespace echoway::scene
