#pragma once

#include <set>
#include <vector>

#include "geometry/geos.hpp"
#include "source/plan.hpp"

namespace echoway::import {

/// A piece of floor bounded by walls and doors: what becomes a room.
struct Cell {
  geos::Shape floor;
  const PlanUnit* unit = nullptr;         ///< The unit that it is; null when the plan names none.
  std::vector<const PlanUnit*> contains;  ///< Other units that lie in it.
  geos::Bounds bounds{};                  ///< Of `floor`.
};

/// One level cut into cells. Points into the PlanLevel that it was made from.
struct LevelFloor {
  const PlanLevel* plan = nullptr;
  std::vector<Cell> cells;
  geos::Shape solids;    ///< Walls, windows, columns, shafts; no doors.
  geos::Shape inside;    ///< All that is under the building's roof as far as the plan tells.
  geos::Shape outdoors;  ///< Parts of `inside` that are open to the outside.

  /// Index of the cell in which `p` lies, -1 when in none.
  [[nodiscard]] int cell_at(Vec2 p) const;
  /// Index of the cell nearest to `p` within `reach` metres, -1 when there is none.
  [[nodiscard]] int cell_near(Vec2 p, double reach) const;
};

/// Cuts a level into cells: what is inside the outline (or, without one, in units or enclosed by walls), less walls and
/// doors; gaps in walls that nobody fits through are closed, units that stand for walls of their own are cut out.
/// Doors in `open_doors` (indices) do not bar. Repairs are reported when `report` is given.
[[nodiscard]] LevelFloor cut_floor(const PlanLevel& level, const std::set<std::size_t>& open_doors, Report* report);

/// The area of a feature's polygons.
[[nodiscard]] geos::Shape shape_of(const Area& area);

}  // namespace echoway::import
