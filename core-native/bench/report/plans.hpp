#pragma once

#include <cstdint>
#include <string_view>

#include "echoway/building/building.hpp"
#include "echoway/sim/world.hpp"

namespace echoway::report {

/// A building of maps/. Throws std::runtime_error when it cannot be loaded.
[[nodiscard]] Building load_plan(std::string_view name);

// Plans that say less, or something else, than the building that is walked through.

[[nodiscard]] Building without_reflectors(Building plan);
[[nodiscard]] Building without_corners_and_edges(Building plan);
/// Every wall off by `by` metres, to one side or the other; what runs along a wall goes with it. For rooms whose walls
/// run along their frame's axes.
[[nodiscard]] Building walls_off(Building plan, double by, std::uint64_t seed);
/// In every room, the wall at the far end of the room's longer side moved by `by` metres; rooms as for walls_off().
[[nodiscard]] Building partitions_moved(Building plan, double by);
/// A cupboard of 1.2 x 0.6 m against a wall of every room that has space for one, clear of doors.
[[nodiscard]] Building with_cupboards(Building plan, std::uint64_t seed);

/// The furnished world with as much in it as the thesis says of one of its rooms (sections 6.2.1 and 6.2.5).
[[nodiscard]] sim::World world_of_room(std::string_view id);

}  // namespace echoway::report
