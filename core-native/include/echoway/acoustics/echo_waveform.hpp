#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "echoway/acoustics/element.hpp"
#include "echoway/acoustics/transducer.hpp"

namespace echoway {

/// Amplitude of an edge's echo over a plane's at the same distance: (2 pi sqrt(z / lambda))^-1 (Kuc and Siegel; thesis
/// section 4.2), 37 dB down at 1 m and 42 dB at 3 m. At most 1: nearer than lambda / (4 pi^2) the formula is outside
/// the far field that it holds in.
[[nodiscard]] double edge_diffraction_factor(double distance_m, double wavelength_m) noexcept;

/// Peak amplitude of an echo met head-on, per metre: 1/(2z) for walls and right-angled corners alike (one transducer
/// cannot tell them apart) and for all-reflective elements, times the diffraction factor for edges.
/// 0 for `none` and for distances that are not positive.
[[nodiscard]] double reflection_amplitude(ElementKind kind, double distance_m, double wavelength_m) noexcept;

/// The ranging module's receiver (thesis section 6.1): its gain grows until 38 ms after the ping, which makes up for
/// spreading, and the first echo above a threshold stops the clock.
struct Receiver {
  double full_gain_s = 0.038;  ///< > 0.
  double threshold = 0.0;      ///< Of amplitude times gain, per metre.

  /// In proportion to the elapsed time, which cancels 1/(2z) exactly, up to 1 at `full_gain_s`. 0 before the ping.
  [[nodiscard]] double gain(double time_s) const noexcept;
};

/// A burst or an echo in quadrature: sample k is the mean over a cell of `period_s` centred at start_s + k period_s;
/// the pressure is the imaginary part and the modulus is the envelope. Empty when the input made no sense.
struct Waveform {
  double start_s = 0.0;
  double period_s = 0.0;
  std::vector<std::complex<double>> sample;

  [[nodiscard]] double time(std::size_t k) const noexcept { return start_s + static_cast<double>(k) * period_s; }
  /// The largest modulus; 0 when empty.
  [[nodiscard]] double peak() const noexcept;
};

/// The transmitted burst p(t) = sin^2(pi t/T) exp(2 pi i f t) for 0 <= t <= T = cycles/f, of unit peak, averaged
/// exactly over every cell. The rise and fall stand for the resonance of the foil.
[[nodiscard]] Waveform transmit_pulse(const Transducer& transducer, double period_s);

/// The echo r(t) = p * h_T * h_R (thesis (4.5)) of one element, scaled by reflection_amplitude(). Time counts from the
/// start of the transmitted burst. The period is lengthened where pulse and response would have more than 8192 cells
/// together, which bounds the work; from a quarter of a cycle on a coarser period averages the tone away.
[[nodiscard]] Waveform echo_waveform(const Transducer& transducer, ElementKind kind, double distance_m,
                                     double inclination, double period_s);

/// When the echo's envelope, amplified, first reaches the threshold (interpolated between samples); nothing when it
/// never does. The envelope is used rather than the tone so that the time is a continuous function of pose.
[[nodiscard]] std::optional<double> first_crossing(const Waveform& echo, const Receiver& receiver) noexcept;

}  // namespace echoway
