#pragma once

#include <cstddef>

#include "scene/scene.hpp"
#include "tracker/population.hpp"

namespace echoway::tracker {

/// Particles of a population of `capacity` that leave room for all of their twins.
[[nodiscard]] constexpr std::size_t without_twins(std::size_t capacity) noexcept { return capacity * 5 / 8; }

/// Adds to places that a search found those that look nearly the same: a rectangular room turned by half a turn differs in its
/// doors alone, a square one turned by a quarter too. A cupboard that no plan knows is enough for a search to find the wrong
/// one of them, within centimetres, and to drop the right one for good. Together they are given a tenth of its odds: what
/// was found may be reported for sure at once, and modes keep the others until the echoes have told. Places outside the floor are left out.
/// REQUIRES: not resampled by modes. Those that find no more room are left out. No allocation.
void add_twins(Population& population, const scene::Scene& scene) noexcept;

}  // namespace echoway::tracker
