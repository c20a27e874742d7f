#pragma once

#include <vector>

#include "echoway/routing/free_space.hpp"

namespace echoway::routing {

/// A room's walls once its doors are cut out of them.
struct CutWalls {
  std::vector<Segment> walls;     ///< What is left.
  std::vector<Segment> doorways;  ///< What was cut out.
};

/// The doors of `room`, put onto the nearest wall; `inward` points to one side of it, not yet necessarily the inside.
[[nodiscard]] std::vector<Opening> find_openings(const Building& building, RoomIndex room);

/// Walls that run along an opening lose the part that lies in it; walls that meet it at an angle are jambs and stay.
[[nodiscard]] CutWalls cut_openings(const std::vector<Segment>& walls, const std::vector<Opening>& openings);

}  // namespace echoway::routing
