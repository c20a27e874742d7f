#include "guidance/heard_space.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway::guidance {
namespace {

constexpr double kFresh = 1.3;               ///< Seconds: a pass and a little more.
constexpr double kHands = 0.25;              ///< Nearer echoes are the wearer's own hands, metres from the belt.
constexpr double kAbreast = degrees(62.0);   ///< What stands this far aside is met by a shoulder.
constexpr int kEnough = 2;                   ///< Of the five sensors or so that look there.

}  // namespace

void HeardSpace::on_firing(const Firing& firing) noexcept {
  if (firing.sensor < 0 || firing.sensor >= belt_->sensors || !std::isfinite(firing.time_s)) return;
  const bool echo = firing.has_echo() && std::isfinite(firing.range_m);
  if (echo && firing.range_m < kHands) return;
  heard_[static_cast<std::size_t>(firing.sensor)] = {firing.time_s, echo ? firing.range_m + belt_->radius_m : -1.0};
}

std::optional<double> HeardSpace::nearest(double direction, double half_rad, int least, double now) const noexcept {
  int echoes = 0;
  double best = 1e9;
  for (int i = 0; i < belt_->sensors; ++i) {
    const Heard& h = heard_[static_cast<std::size_t>(i)];
    if (h.range_m < 0.0 || now - h.time_s > kFresh) continue;
    if (std::abs(wrap_angle(belt_->bearing(i) - direction)) > half_rad) continue;
    ++echoes;
    best = std::min(best, h.range_m);
  }
  if (echoes < least) return std::nullopt;
  return best;
}

bool HeardSpace::is_free(double direction, double free_m, double now) const noexcept {
  const auto echo = nearest(direction, kAbreast, kEnough, now);
  return echo && *echo >= free_m;
}

std::optional<double> HeardSpace::most_free(double free_m, double preferred, double now) const noexcept {
  constexpr double kDraw = 1.3;
  constexpr double kSame = degrees(46.0);
  std::optional<double> best;
  double furthest = 0.0;
  for (const double direction : {0.0, kPi / 2, -kPi / 2, kPi}) {
    const auto echo = nearest(direction, kAbreast, kEnough, now);
    if (!echo || *echo < free_m) continue;
    const bool same = std::abs(wrap_angle(direction - preferred)) < kSame;
    const double worth = *echo * (same ? kDraw : 1.0);
    if (worth <= furthest) continue;
    furthest = worth;
    best = direction;
  }
  return best;
}

std::optional<double> HeardSpace::ahead(double now) const noexcept {
  return nearest(0.0, kPi / belt_->sensors + degrees(13.0), 1, now);
}

}  // namespace echoway::guidance
