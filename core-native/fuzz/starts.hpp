#pragma once

#include "echoway/locate/locator.hpp"
#include "reader.hpp"

namespace echoway::fuzz {

/// A start in plans::two_closets(); seldom one that must be searched for, since a search costs as much as a hundred
/// other inputs.
inline Start any_start(Reader& in) {
  Start start;
  const std::uint8_t what = in.byte();
  if (what == 255) return start;
  start.room = what < 240 ? what % 2 : static_cast<RoomIndex>(what % 8) - 2;
  if (what % 16 != 1) start.position = what % 16 == 2 ? Vec2{in.number(), in.number()} : in.spot();
  if (what % 16 != 3) start.heading = in.number();
  return start;
}

}  // namespace echoway::fuzz
