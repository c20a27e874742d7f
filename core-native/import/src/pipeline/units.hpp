#pragma once

#include <vector>

#include "pipeline/floor.hpp"

namespace echoway::import {

/// Cuts units that stand for walls of their own out of the cells: the smaller unit first, so that where two overlap it
/// keeps the common part. Strips that remain between a unit and a wall, too narrow for a person, go to the unit.
[[nodiscard]] std::vector<Cell> cut_out_units(const PlanLevel& level, std::vector<Cell> cells, Report* report);

/// Finds the unit that every cell is (the one that it agrees with best) and those that lie in it.
void attach_units(const PlanLevel& level, std::vector<Cell>& cells);

}  // namespace echoway::import
