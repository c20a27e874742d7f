#include "guidance/spoken_turn.hpp"

#include <cmath>

#include "echoway/units.hpp"

namespace echoway::guidance {

double understood(double direction) noexcept {
  const double side = direction > 0.0 ? 1.0 : -1.0;
  switch (sector_of(direction)) {
    case Sector::ahead:
      return 0.0;
    case Sector::slightly_left:
    case Sector::slightly_right:
      return side * degrees(32.0);
    case Sector::left:
    case Sector::right:
      return side * degrees(85.0);
    case Sector::sharp_left:
    case Sector::sharp_right:
      return side * degrees(140.0);
    case Sector::behind:
      break;
  }
  return kPi;
}

double told(double off) noexcept {
  constexpr double kMiddle = degrees(58.0);
  const double most_slight = degrees(45.0);
  const bool between = std::abs(off) > most_slight && std::abs(off) < kMiddle;
  return between ? std::copysign(most_slight, off) : off;
}

void put_turn_in_tail(Cue& cue, CueKind kind, double direction) noexcept {
  cue.tail = {CueKind::turn, true, direction, -1.0};
  cue.kind = kind;
  cue.has_direction = false;
  cue.direction = 0.0;
}

}  // namespace echoway::guidance
