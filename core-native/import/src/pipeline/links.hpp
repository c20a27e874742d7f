#pragma once

#include <vector>

#include "pipeline/rooms.hpp"

namespace echoway::import {

/// Stairs or an elevator between two cells on different levels (indices into `levels` and their cells).
struct PlacedLink {
  LevelLinkKind kind = LevelLinkKind::stairs;
  std::size_t level_a = 0, level_b = 0;
  int cell_a = 0, cell_b = 0;
  Vec2 at_a{}, at_b{};
};

/// Joins levels: as the plan declares, else where stairs lie above stairs on the next level and elevators above
/// elevators on any level. Stairs that join nothing are reported.
[[nodiscard]] std::vector<PlacedLink> find_links(const Plan& plan, const std::vector<LevelRooms>& levels,
                                                 Report& report);

}  // namespace echoway::import
