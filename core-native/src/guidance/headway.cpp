#include "guidance/headway.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoway::guidance {

bool Headway::update(double now, double cost, double instructed_s) noexcept {
  constexpr double kNearer = 0.5;     // metres
  constexpr double kElsewhere = 2.0;  // metres at once: they are taken to be somewhere else
  constexpr double kLed = 35.0;       // s
  constexpr int kTold = 7;
  constexpr double kBreak = 0.5;      // s; longer ones are no leading
  const double seconds = std::clamp(now - std::exchange(last_, now), 0.0, kBreak);
  if (!std::isfinite(cost)) return false;
  const bool elsewhere = std::abs(cost - std::exchange(cost_, cost)) > kElsewhere;
  if (elsewhere || cost < least_ - kNearer) count_from(cost);
  led_s_ += seconds;
  if (std::exchange(last_told_, instructed_s) < instructed_s) ++told_;
  if (led_s_ < kLed || told_ < kTold) return false;
  count_from(cost);
  return true;
}

void Headway::count_from(double cost) noexcept {
  least_ = cost;
  led_s_ = 0.0;
  told_ = 0;
}

}  // namespace echoway::guidance
