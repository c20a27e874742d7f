#pragma once

#include "tracker/likelihood.hpp"

namespace echoway::tracker {

// What the belt hears on stairs and in elevators, of which a plan shows but the two ends: densities of a shot's
// reading, per metre for an echo and a plain probability for none. They add up to 1 over the ranges that belts hear, so
// that a room that explains the echoes is, after some of them, the likelier place.

/// In an elevator's cabin, whose walls are all near.
[[nodiscard]] double in_cabin(const Shot& shot) noexcept;

/// On stairs, where walls, balusters and risers come near and go. `echo_share`:
/// which share of all firings is answered, 0 to 1.
[[nodiscard]] double on_stairs(const Shot& shot, double echo_share) noexcept;

}  // namespace echoway::tracker
