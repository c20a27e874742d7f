#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"

namespace echoway::eval {

/// A corridor with rooms of random width and depth on both sides, some of them L-shaped, some with lab benches, some
/// joined to their neighbour: a different building for every seed.
[[nodiscard]] Building random_office(int rooms_per_side, std::uint64_t seed);

/// A corridor with identical rooms (thesis section 6.2.5, case I).
[[nodiscard]] Building twin_rooms(int rooms);

}  // namespace echoway::eval
