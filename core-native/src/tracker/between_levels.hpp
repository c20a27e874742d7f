#pragma once

#include "tracker/likelihood.hpp"

namespace echoway::tracker {

// What the belt hears on stairs and in elevators, of which a plan shows but the two ends: densities of a shot's
// reading, per metre for an echo and a plain probability for none. They add up to 1, so that a room that explains the
// echoes is always the likelier place.

/// In an elevator's cabin, whose walls are all near.
[[nodiscard]] double in_cabin(const Shot& shot) noexcept;

/// On stairs, where walls, balusters and risers come near and go. `echo_share`: of the firings that are answered.
[[nodiscard]] double on_stairs(const Shot& shot, double echo_share) noexcept;

}  // namespace echoway::tracker
