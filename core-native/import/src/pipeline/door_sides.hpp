#pragma once

#include "pipeline/floor.hpp"

namespace echoway::import {

/// A door before it is known what it joins.
struct DoorCandidate {
  Vec2 centre{};
  Vec2 along{};             ///< Unit vector along the wall.
  double width = 0.0;       ///< Metres.
  double half_depth = 0.0;  ///< Metres; half the extent of its area across the wall, 0 for a line or a point.
};

/// What lies beyond a door on one side.
struct DoorSide {
  enum class Kind {  // What is more of a door comes first.
    cell,     ///< Floor.
    outside,  ///< The open, or what the plan says is outdoors.
    court,    ///< Nothing that the plan draws, with rooms all round: a court, a shaft, a thick wall.
    blocked,  ///< A wall.
  };
  Kind kind = Kind::blocked;
  int cell = -1;          ///< Index in LevelFloor::cells, -1 when it is none.
  double distance = 0.0;  ///< Metres from the door's centre to where the cell begins, or as far as was looked.
};

/// Whether two looks saw the same, however far off.
[[nodiscard]] constexpr bool same_beyond(const DoorSide& a, const DoorSide& b) noexcept {
  return a.kind == b.kind && a.cell == b.cell;
}

struct DoorSides {
  DoorSide front, back;  ///< Towards perpendicular(along), and behind.

  [[nodiscard]] bool within_one_cell() const noexcept {
    return front.kind == DoorSide::Kind::cell && same_beyond(front, back);
  }
  /// A room with another, with the outside or with a court.
  [[nodiscard]] bool joins_two() const noexcept {
    return has(DoorSide::Kind::cell) && !has(DoorSide::Kind::blocked) && !within_one_cell();
  }
  [[nodiscard]] bool has(DoorSide::Kind kind) const noexcept { return front.kind == kind || back.kind == kind; }
};

/// Looks for what lies on both sides of the doors of a level.
class DoorLooker {
 public:
  /// The floor must outlive it.
  explicit DoorLooker(const LevelFloor& floor);

  /// Up to `reach` metres from the door's centre.
  [[nodiscard]] DoorSides within(const DoorCandidate& door, double reach) const;
  /// For a door drawn as a line or a point, up to kWallReach; where that finds one room, up to another one behind a
  /// wall of kThickestWall.
  [[nodiscard]] DoorSides through_wall(const DoorCandidate& door) const;

  /// Metres.
  static constexpr double kWallReach = 0.6;
  /// Metres. Old masonry is as thick as that; two rooms further apart may have a passage between them, for no corridor
  /// that people pass each other in is narrower.
  static constexpr double kThickestWall = 1.2;

 private:
  [[nodiscard]] DoorSide look(const DoorCandidate& door, Vec2 n, double reach) const;
  [[nodiscard]] DoorSide look_from(Vec2 from, Vec2 n, double reach) const;
  [[nodiscard]] DoorSide nothing_at(Vec2 p, double reach) const;
  void look_further(const DoorCandidate& door, Vec2 n, const DoorSide& near, DoorSide& far) const;
  [[nodiscard]] double refine(Vec2 from, Vec2 n, double inside, int cell) const;

  const LevelFloor& floor_;
  geos::Shape enclosed_;  // what is inside, and what has that all round
};

}  // namespace echoway::import
