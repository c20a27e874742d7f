#include "guidance/heard_space.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway::guidance {
namespace {

constexpr double kFresh = 1.3;               ///< Seconds: a pass and a little more.
constexpr double kHands = 0.25;              ///< Nearer echoes are the wearer's own hands, metres from the belt.

}  // namespace

void HeardSpace::on_firing(const Firing& firing) noexcept {
  if (firing.sensor < 0 || firing.sensor >= belt_->sensors || !std::isfinite(firing.time_s)) return;
  const bool echo = firing.has_echo() && std::isfinite(firing.range_m);
  if (echo && firing.range_m < kHands) return;
  heard_[static_cast<std::size_t>(firing.sensor)] = {firing.time_s, echo ? firing.range_m + belt_->radius_m : -1.0};
}

std::optional<double> HeardSpace::fresh(int sensor, double now) const noexcept {
  const Heard& h = heard_[static_cast<std::size_t>(sensor)];
  return h.range_m < 0.0 || now - h.time_s > kFresh ? std::nullopt : std::optional(h.range_m);
}

std::optional<double> HeardSpace::way(double direction, double now) const noexcept {
  constexpr double kAbreast = degrees(62.0);  // what stands this far aside is met by a shoulder
  constexpr int kEnough = 2;                  // of the five sensors or so that look there
  constexpr double kHalfBreadth = 0.45;       // of the lane that must be free, metres
  constexpr double kUnheard = 2.5;            // of a lane in which nothing answers, metres
  int echoes = 0;
  std::optional<double> free;
  for (int i = 0; i < belt_->sensors; ++i) {
    const auto range = fresh(i, now);
    const double aside = wrap_angle(belt_->bearing(i) - direction);
    if (!range || std::abs(aside) > kAbreast) continue;
    ++echoes;
    if (*range * std::abs(std::sin(aside)) > kHalfBreadth) continue;
    const double on = *range * std::cos(aside);
    free = free ? std::min(*free, on) : on;
  }
  if (echoes < kEnough) return std::nullopt;
  return free.value_or(kUnheard);
}

std::optional<double> HeardSpace::ahead(double now) const noexcept {
  const double half = kPi / belt_->sensors + degrees(13.0);
  std::optional<double> nearest;
  for (int i = 0; i < belt_->sensors; ++i) {
    const auto range = fresh(i, now);
    if (!range || std::abs(wrap_angle(belt_->bearing(i))) > half) continue;
    nearest = nearest ? std::min(*nearest, *range) : *range;
  }
  return nearest;
}

}  // namespace echoway::guidance
