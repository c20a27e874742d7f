#include "tracker/echo_repeats.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kOldest = 2.5;          // Seconds after which an echo is forgotten.
constexpr double kAgain = 0.5;           // Chance that what answered once answers again from where it was,
constexpr double kSameRange = 0.25;      // and that it does so from the same distance.
constexpr double kRangeSigma = 0.08;     // Metres,
constexpr double kSigmaPerSecond = 0.06; // and for every second since.
constexpr double kBesideAxis = 0.92;     // Cosine: 23 degrees off the axis.
constexpr double kGate = 3.5;

double gaussian(double off, double sigma) noexcept {
  const double x = off / sigma;
  return std::abs(x) > kGate ? 0.0 : kInvSqrtTwoPi / sigma * fast_exp(-0.5 * x * x);
}

}  // namespace

void EchoRepeats::move(double forward, double turn) noexcept {
  const double middle = pose_.heading + 0.5 * turn;
  const SinCos way = fast_sincos(wrap_near(middle));
  pose_.position = pose_.position + forward * Vec2{way.cos, way.sin};
  pose_.heading = wrap_near(pose_.heading + turn);
}

std::span<const Repeat> EchoRepeats::match(const BeltConfig& belt, int sensor, double range, double time_s) noexcept {
  std::size_t count = 0;
  const SinCos a = fast_sincos(wrap_near(pose_.heading + belt.bearing(sensor)));
  const Vec2 axis{a.cos, a.sin};
  const Vec2 eye = pose_.position + belt.radius_m * axis;
  const auto keep = [&](int whose, double density) {
    if (density <= 0.0) return;
    if (count < kMost) {
      found_[count++] = {whose, density};
      return;
    }
    const auto fainter = [](const Repeat& x, const Repeat& y) { return x.density < y.density; };
    const auto weakest = std::min_element(found_.begin(), found_.end(), fainter);
    if (density > weakest->density) *weakest = {whose, density};
  };
  for (int i = 0; i < belt.sensors; ++i) {
    const Last& last = last_[static_cast<std::size_t>(i)];
    const double age = time_s - last.time_s;
    if (!(age < kOldest) || age < 0.0) continue;
    const double sigma = kRangeSigma + kSigmaPerSecond * age;
    double density = 0.0;
    const Vec2 way = last.at - eye;
    const double d = std::sqrt(squared_norm(way));
    if (std::abs(d - range) < kGate * sigma && dot(way, axis) > kBesideAxis * d) {
      density += kAgain * gaussian(range - d, sigma);
    }
    if (i == sensor) density += kSameRange * gaussian(range - last.range, sigma);
    keep(i, density);
  }
  return {found_.data(), count};
}

void EchoRepeats::note(const BeltConfig& belt, int sensor, double range, double time_s) noexcept {
  const SinCos a = fast_sincos(wrap_near(pose_.heading + belt.bearing(sensor)));
  const Vec2 at = pose_.position + (belt.radius_m + range) * Vec2{a.cos, a.sin};
  last_[static_cast<std::size_t>(sensor)] = {time_s, range, at};
}

}  // namespace echoway::tracker
