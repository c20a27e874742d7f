#pragma once

#include <cstddef>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"

namespace echoway {

/// How many there are of each kind of thing that can send sound back.
struct EchoSources {
  std::size_t walls = 0;             ///< Pieces of walls, which doors cut.
  std::size_t corners = 0;
  std::size_t edges = 0;             ///< Door jambs included.
  std::size_t all_reflective = 0;
  std::size_t mirrored_corners = 0;  ///< Corners that are heard by way of a wall.

  [[nodiscard]] std::size_t total() const noexcept {
    return walls + corners + edges + all_reflective + mirrored_corners;
  }
};

/// What the estimator leaves out of one room's echoes because nobody in the room can tell, and what that saves. A place
/// is a square of the floor, usually half a metre wide; means are over the room's places and all directions.
struct RoomSavings {
  RoomIndex room = kNoRoom;
  EchoSources within_reach;         ///< All that the plan has in the room and beyond up to two open doors.
  EchoSources heard;                ///< Of these what somebody on some place of the room can hear. The rest is left
                                    ///< out; a kind without any is never worked out in this room.
  std::size_t sight_blockers = 0;   ///< Walls and all-reflective elements, beyond doors too, that may hide something.
  double listed = 0.0;              ///< Mean number that one place keeps, for all directions.
  double looked_at = 0.0;           ///< Mean number that one firing looks at.
  double sight_tests = 0.0;         ///< Mean number of tests whether something stands in between; else
                                    ///< looked_at * sight_blockers.
  double plain_floor = 0.0;         ///< Share of the places from where nobody can leave the room: no doors are looked
                                    ///< at there.
};

struct SceneReport {
  std::vector<RoomSavings> rooms;   ///< In the building's order.
  std::size_t sources = 0;          ///< All that can send sound back in the building, each in its own room.
  bool levels = false;              ///< More than one level; else stairs and elevators are left out.
  std::size_t bytes = 0;            ///< Held by the compiled building.
};

/// Compiles every place of `building` for `belt` and counts.
[[nodiscard]] SceneReport report_scene(const Building& building, const BeltConfig& belt);

}  // namespace echoway
