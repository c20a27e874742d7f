#pragma once

namespace echoway::sim {

/// Bessel function of the first kind, order 1; |error| < 1e-7 (Abramowitz and Stegun 9.4.4, 9.4.6).
[[nodiscard]] double bessel_j1(double x) noexcept;

/// One-way directivity of a baffled circular piston, 2 J1(x)/x with x = k a sin(theta), signed, 1 on the axis.
[[nodiscard]] double piston_directivity(double wave_number, double radius_m, double sin_theta) noexcept;

}  // namespace echoway::sim
