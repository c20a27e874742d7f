#include "acoustics/receiver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "acoustics/piston.hpp"

namespace echoway::sim {
namespace {

constexpr double kReferencePath = 4.0;      // There and back to a plane 2 m off.
constexpr double kGainRiseDb = 40.0;        // From the first gain step to the last.
constexpr double kPulse = 16.0;             // Cycles in the ping: the echo's envelope rises that long.
// Times at which the ranging module raises its gain, seconds after the ping (TL851/TL852 step table; the last is the
// thesis's "maximum 38 ms after emission").
constexpr std::array<double, 11> kGainSteps{2.38e-3,  5.12e-3,  7.87e-3,  10.6e-3,  13.35e-3, 16.09e-3,
                                            18.84e-3, 21.59e-3, 27.07e-3, 32.55e-3, 38.04e-3};

double from_db(double db) { return std::pow(10.0, db / 20.0); }

}  // namespace

Receiver::Receiver(const World& world)
    : radius_(world.transducer_radius_m),
      absorption_(world.absorption_db_per_m * std::log(10.0) / 20.0),
      sound_speed_(speed_of_sound(world.temperature_c)),
      margin_(from_db(world.plane_margin_db)) {
  wavelength_ = sound_speed_ / world.frequency_hz;
  wave_number_ = kTwoPi / wavelength_;
  least_ = 1.0 / (margin_ * gain(1e9));
}

double Receiver::gain(double path_m) const noexcept {
  const auto steps_by = [this](double path) {
    const double t = path / sound_speed_;
    return static_cast<double>(std::upper_bound(kGainSteps.begin(), kGainSteps.end(), t) - kGainSteps.begin());
  };
  const double per_step = kGainRiseDb / static_cast<double>(kGainSteps.size());
  return from_db(per_step * (steps_by(path_m) - steps_by(kReferencePath)));
}

double Receiver::mirror_amplitude(double path_m, double cos_out, double cos_in) const noexcept {
  const auto pattern = [this](double cos_theta) {
    if (cos_theta <= 0.0) return 0.0;
    const double sin_theta = std::sqrt(std::max(0.0, 1.0 - cos_theta * cos_theta));
    return cos_theta * piston_directivity(wave_number_, radius_, sin_theta);
  };
  const double spreading = kReferencePath / std::max(path_m, 0.05);
  const double air = std::exp(-absorption_ * (path_m - kReferencePath));
  return std::abs(pattern(cos_out) * pattern(cos_in)) * spreading * air;
}

double Receiver::scatter_loss(double distance_m, double radius_m) const noexcept {
  const double z = std::max(distance_m, 0.02);
  if (radius_m > 0.0) return std::sqrt(0.5 * radius_m / (z + 0.5 * radius_m));
  return 1.0 / (kTwoPi * std::sqrt(z / wavelength_));
}

double Receiver::end_taper(double inside_m, double path_m) const noexcept {
  const double zone = 0.5 * std::sqrt(0.5 * wavelength_ * path_m);
  return 0.5 * std::erfc(-inside_m / zone);
}

double Receiver::over_threshold(const Arrival& arrival) const noexcept {
  return arrival.amplitude * margin_ * gain(arrival.path_m);
}

std::optional<double> Receiver::first_crossing(const std::vector<Arrival>& arrivals) const {
  const double pulse_m = kPulse * wavelength_;
  std::optional<double> first;
  for (const Arrival& arrival : arrivals) {
    const double ratio = over_threshold(arrival);
    if (ratio < 1.0) continue;
    const double crossing = arrival.path_m + pulse_m * (1.0 / ratio - 1.0 / margin_);
    if (!first || crossing < *first) first = crossing;
  }
  return first;
}

double Receiver::plane_half_angle(double distance_m) const {
  for (double angle = 0.0; angle < degrees(89.0); angle += degrees(0.05)) {
    const double cosine = std::cos(angle);
    if (over_threshold({2.0 * distance_m, mirror_amplitude(2.0 * distance_m, cosine, cosine)}) < 1.0) return angle;
  }
  return degrees(89.0);
}

}  // namespace echoway::sim
