#pragma once

#include <cstddef>

#include "scene/scene.hpp"
#include "tracker/population.hpp"

namespace echoway::tracker {

/// How many particles of a population of `capacity` leave room for all of their twins.
[[nodiscard]] std::size_t without_twins(std::size_t capacity) noexcept;

/// Adds to places that a search found those that look nearly the same: a rectangular room turned by half a turn differs
/// in its doors alone, a square one turned by a quarter too. A cupboard that no plan knows is enough for a search to
/// find the wrong one of them, within centimetres, and to drop the right one for good. Together they are given a tenth
/// of its odds: what was found may be reported for sure at once, and modes keep the others until the echoes have told.
/// Twins outside the floor are left out, and those that find no more room. No allocation.
/// REQUIRES: not resampled by modes since it was empty.
void add_twins(Population& population, const scene::Scene& scene) noexcept;

}  // namespace echoway::tracker
