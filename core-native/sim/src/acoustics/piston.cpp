#include "acoustics/piston.hpp"

#include <cmath>

namespace echoway::sim {

double bessel_j1(double x) noexcept {
  const double ax = std::abs(x);
  double value = 0.0;
  if (ax <= 3.0) {
    const double y = (ax / 3.0) * (ax / 3.0);
    value =
        ax * (0.5 + y * (-0.56249985 +
                         y * (0.21093573 + y * (-0.03954289 + y * (0.00443319 + y * (-0.00031761 + y * 0.00001109))))));
  } else {
    const double y = 3.0 / ax;
    const double f =
        0.79788456 +
        y * (0.00000156 + y * (0.01659667 + y * (0.00017105 + y * (-0.00249511 + y * (0.00113653 - y * 0.00020033)))));
    const double phase =
        ax - 2.35619449 +
        y * (0.12499612 + y * (0.00005650 + y * (-0.00637879 + y * (0.00074348 + y * (0.00079824 - y * 0.00029166)))));
    value = f * std::cos(phase) / std::sqrt(ax);
  }
  return x < 0.0 ? -value : value;
}

double piston_directivity(double wave_number, double radius_m, double sin_theta) noexcept {
  const double x = wave_number * radius_m * sin_theta;
  if (std::abs(x) < 1e-4) return 1.0 - x * x / 8.0;
  return 2.0 * bessel_j1(x) / x;
}

}  // namespace echoway::sim
