#pragma once

#include <string>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"

namespace echoway {

/// What the estimator leaves out of one room's echoes because the room cannot need it, and what that saves.
struct RoomSavings {
  RoomIndex room = kNoRoom;
  std::size_t reflectors = 0;       ///< All that could matter to someone in the room, beyond its doors included.
  double considered = 0.0;          ///< Mean number that one firing looks at.
  double hidden_tests = 0.0;        ///< Mean number of sight-line tests for those, of `occluders` each without compiling.
  std::size_t occluders = 0;
  bool edges = false;               ///< Some edge is near enough to win somewhere; else diffraction is left out.
  bool all_reflective = false;      ///< Else the beam-edge intersection is never evaluated.
  double plain_floor = 0.0;         ///< Share of the room's cells where nobody can leave the room: no room logic there.
};

struct SceneReport {
  std::vector<RoomSavings> rooms;
  bool levels = false;              ///< More than one level; else stairs and elevators are left out.
  std::size_t bytes = 0;            ///< Held by the compiled building.
};

/// Compiles every cell of `building` for `belt` and counts.
[[nodiscard]] SceneReport report_scene(const Building& building, const BeltConfig& belt);

/// A table of the report, one line a room.
[[nodiscard]] std::string to_string(const SceneReport& report, const Building& building);

}  // namespace echoway
