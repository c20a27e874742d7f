#include "tracker/dead_reckoning.hpp"

#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

// Standard deviations. A belief may have slid along a hall before it was found out.
constexpr double kPlaceSigma = 1.0;               // Metres, before anything is walked,
constexpr double kWaySigma = 0.2;                 // and what is added to it, as a share of the way.
constexpr double kHeadingSigma = degrees(15.0);
constexpr double kTrusted = 0.99;                 // Else the wearer was carried, or the place was wrong already.

}  // namespace

void DeadReckoning::begin(const Placed& at) noexcept {
  at_ = at;
  way_ = 0.0;
  known_ = true;
}

void DeadReckoning::move(double turn, double way) noexcept {
  const SinCos mid = fast_sincos(wrap_near(at_.heading + 0.5 * turn));
  at_.position = at_.position + way * Vec2{mid.cos, mid.sin};
  at_.heading = wrap_near(at_.heading + turn);
  way_ += way;
}

double DeadReckoning::log_prior(const Placed& place, double area) const noexcept {
  double density = 0.0;   // Over that of anywhere.
  if (place.level == at_.level) {
    const double variance = kPlaceSigma * kPlaceSigma + kWaySigma * kWaySigma * way_ * way_;
    const double off = wrap_near(place.heading - at_.heading) / kHeadingSigma;
    const double apart2 = squared_norm(place.position - at_.position);
    const double position = area / (kTwoPi * variance) * fast_exp(-0.5 * apart2 / variance);
    const double heading = kTwoPi * kInvSqrtTwoPi / kHeadingSigma * fast_exp(-0.5 * off * off);
    density = position * heading;
  }
  return fast_log(kTrusted * density + 1.0 - kTrusted);
}

}  // namespace echoway::tracker
