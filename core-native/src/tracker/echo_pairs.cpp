#include "tracker/echo_pairs.hpp"

#include <cmath>
#include <utility>

#include "echoway/units.hpp"

namespace echoway::tracker {
namespace {

constexpr double kOldest = 1.5;                // Seconds.
constexpr double kSameSide = degrees(6.0);     // A sensor that turned by more looks elsewhere.

}  // namespace

std::optional<EchoPair> EchoPairs::hear(int sensor, double range, double time_s) noexcept {
  Last& mine = last_[static_cast<std::size_t>(sensor)];
  const Last last = std::exchange(mine, {time_s, range, turned_});
  const double age = time_s - last.time_s;
  if (!(age > 0.0 && age < kOldest) || !(std::abs(turned_ - last.turned) < kSameSide)) return {};
  return EchoPair{age, last.range, range};
}

}  // namespace echoway::tracker
