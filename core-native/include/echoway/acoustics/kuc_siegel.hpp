#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "echoway/acoustics/transducer.hpp"

namespace echoway {

/// A response in time, symmetric about its centre, held as its exact integral over each of an odd number of cells:
/// cell i covers [centre_s + (i - half() - 1/2) period_s, centre_s + (i - half() + 1/2) period_s]. Times are relative
/// to the centre, so that a far reflector costs no resolution. Empty when the input made no sense.
struct CellResponse {
  double centre_s = 0.0;
  double period_s = 0.0;           ///< As asked for, or longer: no response has more than kMaxCells cells.
  std::vector<double> mass;        ///< Dimensionless, >= 0, symmetric to the last bit.

  [[nodiscard]] std::ptrdiff_t half() const noexcept { return static_cast<std::ptrdiff_t>(mass.size() / 2); }
  [[nodiscard]] double integral() const noexcept { return std::accumulate(mass.begin(), mass.end(), 0.0); }
};

/// Bounds the work at any sample period: 1 ns over the full face of a Polaroid transducer still fits.
inline constexpr std::size_t kMaxCells = (std::size_t{1} << 18) + 1;

/// The sound that a wave front, inclined by `inclination` (radians), leaves on the receiver `distance_m` away:
/// Kuc and Siegel's h_R (thesis (4.2)-(4.4)), centred at z/c, integrated exactly over cells of `period_s`.
///
///     h_R(t) = 2c cos(a) / (pi R sin(a)) sqrt(1 - (c (t - z/c) / (R sin a))^2)
///
/// 1. The integral is cos(a) to 1e-12 for every inclination, radius, distance and period.
/// 2. At a = 0, and wherever the support is shorter than a cell, one cell holds everything (thesis (4.3)).
/// 3. At and beyond 90 degrees nothing is heard: one cell of 0 (thesis (4.4)).
/// Empty unless all four are finite, distance and radius >= 0 and the period > 0.
[[nodiscard]] CellResponse receiver_response(const Transducer& transducer, double distance_m, double inclination,
                                             double period_s);

/// h_T * h_R (thesis (4.1)): by reciprocity the transmitter's response equals the receiver's, so this is h_R convolved
/// with itself, centred at 2z/c, with the integral cos^2(a). Same guarantees and limits as receiver_response().
[[nodiscard]] CellResponse transmit_receive_response(const Transducer& transducer, double distance_m,
                                                     double inclination, double period_s);

/// Cumulative h_R: the share of it before u = c (t - z/c) / (R sin a). 0 below -1, 1 above 1.
/// F(u) = 1/2 + (u sqrt(1 - u^2) + asin u) / pi.
[[nodiscard]] double half_ellipse_cdf(double u) noexcept;

/// Cumulative h_T * h_R in the same unit: the distribution of the sum of two independent half-ellipses, 0 below -2 and
/// 1 above 2. Absolute error below 1e-9.
[[nodiscard]] double half_ellipse_pair_cdf(double w) noexcept;

}  // namespace echoway
