#include "guidance/heard_space.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway::guidance {
namespace {

constexpr double kFresh = 1.3;   ///< Seconds: a pass and a little more.
constexpr double kHands = 0.25;  ///< Nearer echoes from beside are the wearer's own hands, metres from the belt.

/// Arms hang at the wearer's sides: what answers from so near before or behind them is none.
bool may_be_hand(double bearing, double range_m) noexcept {
  constexpr double kBeside = 0.8;  // sine: from 53 degrees on
  return range_m < kHands && std::abs(std::sin(bearing)) > kBeside;
}

}  // namespace

void HeardSpace::on_firing(const Firing& firing) noexcept {
  if (firing.sensor < 0 || firing.sensor >= belt_->sensors || !std::isfinite(firing.time_s)) return;
  const bool echo = firing.has_echo() && std::isfinite(firing.range_m);
  if (echo && may_be_hand(belt_->bearing(firing.sensor), firing.range_m)) return;
  Heard& heard = heard_[static_cast<std::size_t>(firing.sensor)];
  const double before = fresh(firing.sensor, firing.time_s).value_or(-1.0);
  heard = {firing.time_s, echo ? firing.range_m + belt_->radius_m : -1.0, before};
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

std::optional<double> HeardSpace::steady(int sensor, double now) const noexcept {
  constexpr double kSteady = 0.1;  // metres from one pass to the next
  const auto range = fresh(sensor, now);
  const bool holds = range && std::abs(*range - heard_[static_cast<std::size_t>(sensor)].before_m) <= kSteady;
  return holds ? range : std::nullopt;
}

template <class Listen>
std::optional<double> HeardSpace::nearest(double direction, double half, Listen listen) const noexcept {
  std::optional<double> found;
  for (int i = 0; i < belt_->sensors; ++i) {
    const double aside = wrap_angle(belt_->bearing(i) - direction);
    if (std::abs(aside) > half) continue;
    const std::optional<double> heard = listen(i, aside);
    if (heard) found = found ? std::min(*found, *heard) : *heard;
  }
  return found;
}

std::optional<double> HeardSpace::wall(double direction, double now) const noexcept {
  constexpr double kBeyond = degrees(55.0);  // off the direction, what answers lies beside the way
  return nearest(direction, kBeyond, [&](int sensor, double aside) {
    const auto range = steady(sensor, now);
    return range ? std::optional(*range / std::cos(aside)) : std::nullopt;
  });
}

std::optional<double> HeardSpace::toward(double direction, double now) const noexcept {
  return nearest(direction, around(), [&](int sensor, double) { return steady(sensor, now); });
}

bool HeardSpace::answers(double direction, double now) const noexcept {
  return nearest(direction, around(), [&](int sensor, double) { return fresh(sensor, now); }).has_value();
}

bool HeardSpace::is_open(double direction, double free_m, double now) const noexcept {
  const auto answer = toward(direction, now);
  const auto lane = way(direction, now);
  return answer && *answer >= free_m && lane && *lane >= free_m;
}

std::optional<double> HeardSpace::ahead(double now) const noexcept {
  const double half = kPi / belt_->sensors + degrees(13.0);
  return nearest(0.0, half, [&](int sensor, double) { return fresh(sensor, now); });
}

}  // namespace echoway::guidance
