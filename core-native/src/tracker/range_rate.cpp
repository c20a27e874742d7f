#include "tracker/range_rate.hpp"

#include <cmath>

#include "tracker/association.hpp"
#include "tracker/echo_model.hpp"
#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kLeastCosine = 0.6;           // Of the sensor's bearing: what is heard beside says little.
constexpr double kSlowest = 0.2;               // m/s: slower tells standing from walking, which stillness() does,
constexpr double kFastest = 1.7;               // and faster was something else.
constexpr double kNoise = 0.012;               // Metres, of either range,
constexpr double kNoisePerMetre = 0.01;        // and as a share of it.
constexpr double kBob = 0.05;                  // m/s: a trunk slows down and hurries on with each step.
constexpr double kAskew = 0.12;                // Radians: the beam's axis is not where the echo comes from.
constexpr double kSame = 0.75;                 // Of pairs were answered by the same thing twice,
constexpr double kSpeeds = 0.8;                // the others speak for any speed in so many metres a second.
constexpr double kGate2 = 6.0;                 // Squared innovations in variances up to which a reading is believed.
constexpr double kEvidence = 0.3;              // Of it counts between particles: things keep their shape for long.

}  // namespace

std::optional<SpeedReading> speed_by_range_rate(const EchoPair& pair, Vec2 bearing, double pace) noexcept {
  if (!(std::abs(bearing.x) > kLeastCosine) || !(pair.range > kBeyondArms)) return {};
  const double speed = (pair.before - pair.range) / (pair.seconds * bearing.x);
  if (!(speed > kSlowest && speed < kFastest)) return {};
  const double noise = (kNoise + kNoisePerMetre * pair.range) / (pair.seconds * bearing.x);
  const double askew = kAskew * pace * bearing.y / bearing.x;
  return SpeedReading{speed, 2.0 * noise * noise + kBob * kBob + askew * askew};
}

double heed(Particle& p, const SpeedReading& reading, double share) noexcept {
  const double own = reading.variance / share;
  const double variance = p.cov.ss + own;
  const double innovation = reading.speed - p.speed;
  const double off2 = innovation * innovation / variance;
  const double density = kInvSqrtTwoPi / std::sqrt(variance) * fast_exp(-0.5 * off2);
  if (off2 < kGate2) observe_speed(p, reading.speed, own);
  return tempered(kSame * kSpeeds * density + 1.0 - kSame, kEvidence * share);
}

}  // namespace echoway::tracker
