#pragma once

#include <filesystem>
#include <vector>

#include "building/doors.hpp"
#include "building/findings.hpp"
#include "building/source.hpp"
#include "geometry/floor_tracing.hpp"

namespace echoway {

/// A building together with all that its checks look at. Vectors run parallel to Building::rooms or Building::doors.
struct Assembly {
  BuildingSource source;
  Building building;
  std::vector<std::vector<int>> wall_lines;  ///< By room: the file's line of each of Room::walls.
  std::vector<FloorTrace> floors;            ///< By room.
  std::vector<DoorLines> door_lines;         ///< By door.
  std::vector<int> pieces;                   ///< By room, see place_rooms(); empty when the building is unusable.
};

/// Reads a building folder and makes a building of it. Reports what makes it unusable and what was left out; the other
/// warnings are the business of the lints (lint.hpp).
[[nodiscard]] Assembly assemble_building(const std::filesystem::path& dir, Findings& findings);

}  // namespace echoway
