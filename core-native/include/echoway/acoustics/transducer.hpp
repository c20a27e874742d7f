#pragma once

#include "echoway/units.hpp"

namespace echoway {

/// A circular piston that sends and receives. Defaults: the Polaroid electrostatic transducer (thesis table 3.2 and
/// section 6.1): 1.69 in across its housing, an active foil of 38.4 mm, 49.4 kHz, a burst of 16 cycles.
struct Transducer {
  double radius_m = 0.0192;       ///< Of the active face, > 0. The thesis's `a`, physics' `R`.
  double frequency_hz = 49.4e3;   ///< > 0.
  double burst_cycles = 16.0;     ///< Length of the transmitted burst, > 0.
  double sound_speed_mps = speed_of_sound(kReferenceCelsius);

  [[nodiscard]] double wavelength_m() const noexcept { return sound_speed_mps / frequency_hz; }
  /// k = 2 pi f / c, radians a metre (905 at 49.4 kHz).
  [[nodiscard]] double wavenumber() const noexcept { return kTwoPi * frequency_hz / sound_speed_mps; }
  [[nodiscard]] double burst_s() const noexcept { return burst_cycles / frequency_hz; }
};

/// Directivity of a circular piston, 2 J1(x)/x with x = k R sin(inclination): 1 at 0, first null at 3.8317.
/// Even in x, within [-0.1323, 1]; absolute error below 1e-14 for |x| < 60 and below 1e-12 beyond. 0 when x is not
/// finite.
[[nodiscard]] double piston_directivity(double x) noexcept;

}  // namespace echoway
