#pragma once

#include <set>
#include <string>
#include <vector>

#include "pipeline/floor.hpp"

namespace echoway::import {

/// A door with the floor on both sides of it.
struct PlacedDoor {
  static constexpr int kOutside = -1;

  Source source;
  std::string name;
  Vec2 centre{};      ///< Of the opening, anywhere in the thickness of the wall.
  Vec2 along{};       ///< Unit vector along the wall; the normal is perpendicular(along).
  double width = 0.0;
  int front = kOutside;       ///< Cell in front (towards the normal), or kOutside.
  int back = kOutside;        ///< Cell behind.
  double to_front = 0.0;      ///< Metres from the centre to where the cell in front begins.
  double to_back = 0.0;
  geos::Shape drawn;          ///< The door as the plan draws it, when it draws an area.
};

struct DoorPlacement {
  std::vector<PlacedDoor> doors;        ///< Between two cells.
  std::vector<PlacedDoor> exits;        ///< Between a cell (always in front) and the outside.
  std::set<std::size_t> within_a_cell;  ///< Indices of doors drawn as areas with the same cell on both sides.
};

/// Finds what every door of a level joins. Doors beside their wall are moved onto it, leaves of one door are joined;
/// what leads nowhere is reported.
[[nodiscard]] DoorPlacement place_doors(const LevelFloor& floor, Report* report);

}  // namespace echoway::import
