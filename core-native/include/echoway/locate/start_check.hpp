#pragma once

#include "echoway/building/building.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/result.hpp"

namespace echoway {

/// Who stands in a doorway, or has paced out where they stand, may be this far beside the room's floor, metres.
inline constexpr double kBesideRoom = 1.0;

/// Whether somebody can stand at `start`. Fails when its room is none of the building's, a position or heading comes
/// without a room or is not finite, or the position lies more than kBesideRoom outside the room: a slip (feet, or
/// another room's frame) that would be told as a place with confidence.
[[nodiscard]] Status check_start(const Start& start, const Building& building);

}  // namespace echoway
