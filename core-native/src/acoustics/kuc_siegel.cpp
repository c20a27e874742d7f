#include "echoway/acoustics/kuc_siegel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "acoustics/gauss_legendre.hpp"

namespace echoway {
namespace {

// What both responses have in common: `support_units` half-widths of R sin(a)/c to either side of the centre, filled
// from a cumulative function of u that is odd about (0, 1/2).
template <class Cdf>
CellResponse sample_cells(double centre_s, double half_width_s, double support_units, double total, double period_s,
                          Cdf cdf) {
  const double support_s = support_units * half_width_s;
  const double most_half_cells = static_cast<double>(kMaxCells / 2);
  CellResponse response;
  response.centre_s = centre_s;
  response.period_s = std::max(period_s, support_s / most_half_cells);
  const double half_cells = std::ceil(std::max(0.0, support_s / response.period_s - 0.5));
  const auto half = static_cast<std::ptrdiff_t>(std::min(half_cells, most_half_cells));
  response.mass.assign(static_cast<std::size_t>(2 * half + 1), 0.0);
  if (half == 0) {
    response.mass[0] = total;
    return response;
  }
  // Half of it is computed and mirrored: symmetric to the last bit. The telescoping sum keeps the integral.
  const double units_per_cell = response.period_s / half_width_s;
  double before = cdf(0.5 * units_per_cell);
  const auto centre = response.mass.begin() + half;
  centre[0] = total * (2.0 * before - 1.0);
  for (std::ptrdiff_t i = 1; i <= half; ++i) {
    const double upto = i == half ? 1.0 : cdf((static_cast<double>(i) + 0.5) * units_per_cell);
    centre[i] = centre[-i] = total * std::max(0.0, upto - before);
    before = std::max(before, upto);
  }
  return response;
}

bool makes_sense(const Transducer& transducer, double distance_m, double inclination, double period_s) noexcept {
  return std::isfinite(transducer.radius_m) && transducer.radius_m >= 0.0 && std::isfinite(distance_m) &&
         distance_m >= 0.0 && std::isfinite(inclination) && std::isfinite(period_s) && period_s > 0.0 &&
         std::isfinite(transducer.sound_speed_mps) && transducer.sound_speed_mps > 0.0;
}

// cos(a), and 0 for sound that would come from behind (thesis (4.4)).
double obliquity(double inclination) noexcept {
  return std::abs(inclination) < 0.5 * kPi ? std::max(0.0, std::cos(inclination)) : 0.0;
}

// R sin(a)/c; 0 where nothing is heard, so that the response is a single cell.
double half_width(const Transducer& transducer, double inclination) noexcept {
  if (obliquity(inclination) <= 0.0) return 0.0;
  return transducer.radius_m * std::abs(std::sin(inclination)) / transducer.sound_speed_mps;
}

// Integrates f(u) F(w - u) over [w - 1, 1] for w in [0, 2]. Both factors end in square roots at the ends of that
// interval; u = w/2 + (1 - w/2) cos(t) turns these into half-angle sines, so that the quadrature sees a smooth
// function. Differences from 1 are formed by half angles: no square root of a negative rounding error.
class Overlap {
 public:
  Overlap() noexcept {
    const GaussLegendre<kNodes> rule;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const double t = 0.5 * kPi * (1.0 + rule.node[i]);
      below_[i] = 2.0 * std::sin(0.5 * t) * std::sin(0.5 * t);
      above_[i] = 2.0 * std::cos(0.5 * t) * std::cos(0.5 * t);
      weight_[i] = rule.weight[i] * std::sin(t);  // f's 2/pi and the interval's pi/2 cancel
    }
  }

  [[nodiscard]] double operator()(double w) const noexcept {
    const double h = 1.0 - 0.5 * w;
    double sum = 0.0;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const double below = h * below_[i];  // 1 - u
      sum += weight_[i] * std::sqrt(below * (2.0 - below)) * half_ellipse_cdf(1.0 - h * above_[i]);
    }
    return sum * h;
  }

 private:
  static constexpr std::size_t kNodes = 64;
  std::array<double, kNodes> below_{};
  std::array<double, kNodes> above_{};
  std::array<double, kNodes> weight_{};
};

}  // namespace

double half_ellipse_cdf(double u) noexcept {
  if (!(u > -1.0)) return 0.0;
  if (u >= 1.0) return 1.0;
  return 0.5 + (u * std::sqrt((1.0 - u) * (1.0 + u)) + std::asin(u)) / kPi;
}

double half_ellipse_pair_cdf(double w) noexcept {
  if (w < 0.0) return 1.0 - half_ellipse_pair_cdf(-w);
  if (!(w < 2.0)) return 1.0;
  static const Overlap overlap;
  return std::min(1.0, half_ellipse_cdf(w - 1.0) + overlap(w));
}

CellResponse receiver_response(const Transducer& transducer, double distance_m, double inclination, double period_s) {
  if (!makes_sense(transducer, distance_m, inclination, period_s)) return {};
  return sample_cells(distance_m / transducer.sound_speed_mps, half_width(transducer, inclination), 1.0,
                      obliquity(inclination), period_s, half_ellipse_cdf);
}

CellResponse transmit_receive_response(const Transducer& transducer, double distance_m, double inclination,
                                       double period_s) {
  if (!makes_sense(transducer, distance_m, inclination, period_s)) return {};
  const double cosine = obliquity(inclination);
  return sample_cells(2.0 * distance_m / transducer.sound_speed_mps, half_width(transducer, inclination), 2.0,
                      cosine * cosine, period_s, half_ellipse_pair_cdf);
}

}  // namespace echoway
