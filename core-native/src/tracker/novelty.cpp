#include "tracker/novelty.hpp"

#include <algorithm>

#include "echoway/units.hpp"

namespace echoway::tracker {
namespace {

constexpr double kNewPlace = 0.25;              // Metres ...
constexpr double kNewDirection = degrees(8.0);  // ... or a turn after which a sensor sees something else.

}  // namespace

double Novelty::of(int sensor) noexcept {
  Visit& visit = visits_[static_cast<std::size_t>(sensor)];
  const double moved = (travelled_ - visit.travelled) / kNewPlace + (turned_ - visit.turned) / kNewDirection;
  const bool first = !visit.made;
  visit = {true, travelled_, turned_};
  return first ? 1.0 : std::clamp(moved, kLeast, 1.0);
}

double Novelty::progress() const noexcept { return travelled_ / kNewPlace + turned_ / kNewDirection; }

}  // namespace echoway::tracker
