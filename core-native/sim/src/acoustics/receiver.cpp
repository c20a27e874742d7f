#include "acoustics/receiver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "acoustics/piston.hpp"
#include "echoway/geometry/vec2.hpp"

namespace echoway::sim {
namespace {

constexpr double kReferencePath = 4.0;  // There and back to a plane 2 m off.
constexpr double kGainRiseDb = 40.0;    // From the first gain step to the last.
constexpr double kPulse = 16.0;         // Cycles in the ping: the echo's envelope rises that long.
constexpr double kNearestPath = 0.05;   // Metres; shorter paths count as this long.
constexpr double kFirstZero = 3.8317;   // Of the Bessel function J1.
constexpr int kPatternSteps = 4096;     // Of the tabulated directivity; linear between, good to 1e-5.
constexpr int kSamplesPerPulse = 24;    // Of the envelope where echoes overlap.
// Times at which the ranging module raises its gain, seconds after the ping (step table of its control chip; the last
// is the "maximum 38 ms after emission" of the thesis, section 6.1).
constexpr std::array<double, 11> kGainSteps{2.38e-3,  5.12e-3,  7.87e-3,  10.61e-3, 13.35e-3, 16.09e-3,
                                            18.84e-3, 21.58e-3, 27.07e-3, 32.55e-3, 38.04e-3};

double from_db(double db) { return std::pow(10.0, db / 20.0); }

// The complementary error function to 1.5e-7 (Abramowitz and Stegun 7.1.26). Not libm's, whose last bits differ from
// one processor to the next.
double erfc_about(double x) noexcept {
  const double t = 1.0 / (1.0 + 0.3275911 * std::fabs(x));
  const double series =
      t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  const double tail = series * std::exp(-x * x);
  return x < 0.0 ? 2.0 - tail : tail;
}

double steps_by(double time_s) {
  return static_cast<double>(std::upper_bound(kGainSteps.begin(), kGainSteps.end(), time_s) - kGainSteps.begin());
}

}  // namespace

Receiver::Receiver(const World& world)
    : radius_(world.transducer_radius_m),
      absorption_(world.absorption_db_per_m * std::log(10.0) / 20.0),
      sound_speed_(speed_of_sound(world.temperature_c)),
      margin_(from_db(world.plane_margin_db)) {
  wavelength_ = sound_speed_ / world.frequency_hz;
  wave_number_ = kTwoPi / wavelength_;
  pattern_.reserve(kPatternSteps + 2);
  for (int i = 0; i <= kPatternSteps; ++i) {
    const double sine = static_cast<double>(i) / kPatternSteps;
    pattern_.push_back(std::sqrt(1.0 - sine * sine) * piston_directivity(wave_number_, radius_, sine));
  }
  pattern_.push_back(0.0);
}

double Receiver::gain(double path_m) const noexcept {
  const double per_step = kGainRiseDb / static_cast<double>(kGainSteps.size());
  return from_db(per_step * (steps_by(path_m / sound_speed_) - steps_by(kReferencePath / sound_speed_)));
}

double Receiver::directivity(double cos_theta) const noexcept {
  if (cos_theta <= 0.0) return 0.0;
  const double place = kPatternSteps * std::sqrt(std::max(0.0, 1.0 - cos_theta * cos_theta));
  const auto i = static_cast<std::size_t>(place);
  return pattern_[i] + (place - static_cast<double>(i)) * (pattern_[i + 1] - pattern_[i]);
}

double Receiver::first_null() const noexcept { return std::asin(std::min(1.0, kFirstZero / (wave_number_ * radius_))); }

double Receiver::path_amplitude(double path_m) const noexcept {
  return kReferencePath / std::max(path_m, kNearestPath) * std::exp(-absorption_ * (path_m - kReferencePath));
}

double Receiver::scatter_loss(double distance_m, double radius_m) const noexcept {
  const double z = std::max(distance_m, kNearestPath);
  if (radius_m > 0.0) return std::sqrt(0.5 * radius_m / (z + 0.5 * radius_m));
  return 1.0 / (kTwoPi * std::sqrt(z / wavelength_));
}

double Receiver::end_taper(double inside_m, double path_m) const noexcept {
  const double zone = 0.5 * std::sqrt(0.5 * wavelength_ * path_m);
  return 0.5 * erfc_about(-inside_m / zone);
}

double Receiver::over_threshold(double path_m, double received) const noexcept {
  return received * margin_ * gain(path_m);
}

std::optional<double> Receiver::first_crossing(std::vector<Arrival>& arrivals) const {
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) { return a.path_m < b.path_m; });
  const double pulse = kPulse * wavelength_;
  const double step = pulse / kSamplesPerPulse;
  const double calibrated = pulse / margin_;
  // The carrier's phase makes echoes that overlap add up or cancel. The envelope of each rises and falls linearly.
  std::vector<std::complex<double>> phasors;
  phasors.reserve(arrivals.size());
  for (const Arrival& arrival : arrivals) {
    const double received = arrival.amplitude * directivity(arrival.cos_arrival);
    phasors.push_back(std::polar(1.0, std::remainder(wave_number_ * arrival.path_m, kTwoPi)) * received);
  }
  std::size_t first = 0;
  double before = 0.0;
  for (double s = arrivals.empty() ? 0.0 : arrivals.front().path_m; first < arrivals.size(); s += step) {
    while (first < arrivals.size() && arrivals[first].path_m + 2.0 * pulse < s) ++first;
    if (first == arrivals.size()) break;
    if (s < arrivals[first].path_m) {
      s = arrivals[first].path_m;
      before = 0.0;
    }
    std::complex<double> sum{};
    for (std::size_t i = first; i < arrivals.size() && arrivals[i].path_m < s; ++i) {
      const double age = (s - arrivals[i].path_m) / pulse;
      sum += phasors[i] * std::max(0.0, 1.0 - std::abs(age - 1.0));
    }
    const double now = over_threshold(s, hypotenuse(sum.real(), sum.imag()));
    if (now >= 1.0) return s - step * (now - 1.0) / std::max(now - before, 1e-12) - calibrated;
    before = now;
  }
  return std::nullopt;
}

std::optional<double> Receiver::interference_crossing(double level) const noexcept {
  const double per_step = kGainRiseDb / static_cast<double>(kGainSteps.size());
  const double at_reference = steps_by(kReferencePath / sound_speed_);
  for (std::size_t i = 0; i < kGainSteps.size(); ++i) {
    if (level * from_db(per_step * (static_cast<double>(i + 1) - at_reference)) >= 1.0) {
      return kGainSteps[i] * sound_speed_;
    }
  }
  return std::nullopt;
}

double Receiver::plane_half_angle(double distance_m) const {
  const double path = 2.0 * distance_m;
  for (double angle = 0.0; angle < degrees(89.0); angle += degrees(0.05)) {
    const double d = directivity(std::cos(angle));
    if (over_threshold(path, d * d * path_amplitude(path)) < 1.0) return angle;
  }
  return degrees(89.0);
}

double transducer_radius_for(double half_angle, const World& world) {
  // On the main lobe 2 J1(x)/x falls from 1 at x = 0 to 0 at 3.83.
  const double wanted = std::pow(10.0, -world.plane_margin_db / 40.0) / std::cos(half_angle);
  double low = 0.0;
  double high = kFirstZero;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (piston_directivity(middle, 1.0, 1.0) > wanted ? low : high) = middle;
  }
  const double wave_number = kTwoPi * world.frequency_hz / speed_of_sound(world.temperature_c);
  return low / (wave_number * std::sin(half_angle));
}

}  // namespace echoway::sim
