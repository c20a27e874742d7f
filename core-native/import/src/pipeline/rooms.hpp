#pragma once

#include <string>
#include <vector>

#include "pipeline/doors.hpp"
#include "pipeline/floor.hpp"

namespace echoway::import {

/// One level with its doors found, its spaces named, and the spaces nobody can enter left out.
struct LevelRooms {
  LevelFloor floor;
  std::vector<PlacedDoor> doors;
  std::vector<PlacedDoor> exits;
  std::vector<std::string> names;    ///< Of every cell; empty when the plan does not say.
  std::vector<bool> is_destination;  ///< Of every cell: the plan names it, so somebody may want to go there.
};

/// Cuts a level, finds its doors, opens doors that stand within one space, and names what is left in reading order
/// (from the top of the plan, left to right).
[[nodiscard]] LevelRooms find_rooms(const PlanLevel& level, Report& report);

}  // namespace echoway::import
