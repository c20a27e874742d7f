#pragma once

#include "echoway/guidance/cue.hpp"

namespace echoway::guidance {

/// What wearers make of a direction that they are told by sides: its sector's middle, radians from the chest.
[[nodiscard]] double understood(double direction) noexcept;

/// The direction to tell for a turn of `off`: "left" is understood as a right angle, so that a little more than half of
/// one is better told as "slightly left".
[[nodiscard]] double told(double off) noexcept;

/// Gives the turn in the tail, after what `kind` says: "Stop. Turn left.", "New route. Turn left."
void put_turn_in_tail(Cue& cue, CueKind kind, double direction) noexcept;

}  // namespace echoway::guidance
