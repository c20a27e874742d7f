#include "echoway/acoustics/echo_waveform.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/acoustics/kuc_siegel.hpp"
#include "echoway/geometry/vec2.hpp"

namespace echoway {
namespace {

constexpr double kMostCells = 8192.0;

double sinc(double x) noexcept { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

// The integral of exp(i w t) from `a` to `b`, by its mid-point so that w = 0 is not special.
std::complex<double> integrate_tone(double w, double a, double b) noexcept {
  // Not std::polar(): its magnitude may not be negative, and the side lobes of the sinc are.
  const double turn = 0.5 * w * (a + b);
  return (b - a) * sinc(0.5 * w * (b - a)) * std::complex<double>(std::cos(turn), std::sin(turn));
}

bool makes_sense(const Transducer& transducer, double period_s) noexcept {
  return std::isfinite(period_s) && period_s > 0.0 && std::isfinite(transducer.frequency_hz) &&
         transducer.frequency_hz > 0.0 && std::isfinite(transducer.burst_cycles) && transducer.burst_cycles > 0.0;
}

}  // namespace

double edge_diffraction_factor(double distance_m, double wavelength_m) noexcept {
  if (!(distance_m > 0.0) || !(wavelength_m > 0.0)) return 1.0;
  return std::min(1.0, 1.0 / (kTwoPi * std::sqrt(distance_m / wavelength_m)));
}

double reflection_amplitude(ElementKind kind, double distance_m, double wavelength_m) noexcept {
  if (kind == ElementKind::none || !(distance_m > 0.0)) return 0.0;
  const double plane = 0.5 / distance_m;
  return kind == ElementKind::edge ? plane * edge_diffraction_factor(distance_m, wavelength_m) : plane;
}

double Receiver::gain(double time_s) const noexcept { return std::clamp(time_s / full_gain_s, 0.0, 1.0); }

double Waveform::peak() const noexcept {
  double largest = 0.0;
  for (const auto& s : sample) largest = std::max(largest, hypotenuse(s.real(), s.imag()));
  return largest;
}

Waveform transmit_pulse(const Transducer& transducer, double period_s) {
  Waveform pulse;
  if (!makes_sense(transducer, period_s)) return pulse;
  const double length = transducer.burst_s();
  pulse.period_s = std::max(period_s, length / kMostCells);
  pulse.start_s = 0.5 * pulse.period_s;
  const auto cells = static_cast<std::size_t>(std::max(1.0, std::ceil(length / pulse.period_s - 1e-9)));
  const double carrier = kTwoPi * transducer.frequency_hz;
  const double envelope = kTwoPi / length;
  pulse.sample.reserve(cells);
  for (std::size_t k = 0; k < cells; ++k) {
    const double a = std::min(length, static_cast<double>(k) * pulse.period_s);
    const double b = std::min(length, static_cast<double>(k + 1) * pulse.period_s);
    // sin^2(x) = 1/2 - cos(2x)/2: three tones.
    const auto integral = 0.5 * integrate_tone(carrier, a, b) - 0.25 * integrate_tone(carrier + envelope, a, b) -
                          0.25 * integrate_tone(carrier - envelope, a, b);
    pulse.sample.push_back(integral / pulse.period_s);
  }
  return pulse;
}

Waveform echo_waveform(const Transducer& transducer, ElementKind kind, double distance_m, double inclination,
                       double period_s) {
  if (!makes_sense(transducer, period_s) || !std::isfinite(inclination)) return {};
  const double response_s =
      4.0 * transducer.radius_m * std::abs(std::sin(inclination)) / transducer.sound_speed_mps;
  const double period = std::max(period_s, (transducer.burst_s() + response_s) / kMostCells);
  const CellResponse response = transmit_receive_response(transducer, distance_m, inclination, period);
  if (response.mass.empty()) return {};
  const Waveform pulse = transmit_pulse(transducer, response.period_s);
  const double amplitude = reflection_amplitude(kind, distance_m, transducer.wavelength_m());
  Waveform echo;
  echo.period_s = response.period_s;
  echo.start_s = response.centre_s + pulse.start_s - static_cast<double>(response.half()) * response.period_s;
  echo.sample.assign(pulse.sample.size() + response.mass.size() - 1, {});
  for (std::size_t i = 0; i < response.mass.size(); ++i) {
    const double mass = amplitude * response.mass[i];
    if (mass == 0.0) continue;
    for (std::size_t j = 0; j < pulse.sample.size(); ++j) echo.sample[i + j] += mass * pulse.sample[j];
  }
  return echo;
}

std::optional<double> first_crossing(const Waveform& echo, const Receiver& receiver) noexcept {
  double before = 0.0;
  for (std::size_t k = 0; k < echo.sample.size(); ++k) {
    const double time = echo.time(k);
    const double level = std::abs(echo.sample[k]) * receiver.gain(time);
    if (level >= receiver.threshold && level > 0.0) {
      const double rise = level - before;
      const double back = rise > 0.0 ? (level - receiver.threshold) / rise : 0.0;
      return time - std::clamp(back, 0.0, 1.0) * echo.period_s;
    }
    before = level;
  }
  return std::nullopt;
}

}  // namespace echoway
