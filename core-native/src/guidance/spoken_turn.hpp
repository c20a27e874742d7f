#pragma once

#include <array>

#include "echoway/guidance/cue.hpp"
#include "echoway/units.hpp"

namespace echoway::guidance {

/// Directions that can be told by sides, as they are understood: straight on first.
inline constexpr std::array<double, 8> kSpokenDirections{0.0,           degrees(32.0),  degrees(-32.0),  degrees(85.0),
                                                         degrees(-85.0), degrees(140.0), degrees(-140.0), kPi};

/// What wearers make of a direction that they are told by sides: its sector's middle, radians from the chest.
[[nodiscard]] double understood(double direction) noexcept;

/// The direction to tell for a turn of `off`: "left" is understood as a right angle, so that a little more than half of
/// one is better told as "slightly left".
[[nodiscard]] double told(double off) noexcept;

/// Gives the turn in the tail, after what `kind` says: "Stop. Turn left.", "New route. Turn left."
void put_turn_in_tail(Cue& cue, CueKind kind, double direction) noexcept;

}  // namespace echoway::guidance
