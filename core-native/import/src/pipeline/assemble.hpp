#pragma once

#include "echoway/building/building.hpp"
#include "pipeline/links.hpp"

namespace echoway::import {

/// Puts rooms, doors, links, exits and places together. Every room's own frame has its origin at the lower left of its
/// floor and the axes of its level (x east, y north). Corners and edges are left to the loader, which derives them.
/// REQUIRES: `levels` in the order of `plan.levels`.
[[nodiscard]] Building assemble(const Plan& plan, const std::vector<LevelRooms>& levels,
                                const std::vector<PlacedLink>& links, Report& report);

}  // namespace echoway::import
