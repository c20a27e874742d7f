#include <cmath>

#include "echoway/acoustics/transducer.hpp"

namespace echoway {
namespace {

constexpr double kSeriesLimit = 2.0;
constexpr double kAsymptoticLimit = 60.0;

// 2 J1(x)/x = sum over k of (-x^2/4)^k / (k! (k+1)!)  (Abramowitz and Stegun 9.1.10). No division by x, so nothing
// happens at 0; below x = 2 the terms fall from the start and nothing cancels.
double series(double x) noexcept {
  const double q = -0.25 * x * x;
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; std::abs(term) > 1e-18; ++k) {
    term *= q / (k * (k + 1.0));
    sum += term;
  }
  return sum;
}

// 2 J1(x)/x = (2/pi) * integral over [0, pi] of sin^2(t) cos(x cos t) dt (A&S 9.1.20). The integrand is periodic and
// entire, so the trapezoidal rule converges faster than any power as soon as it has more points than x; 2 * 96 points a
// full turn leave less than 1e-16 at x = 60. This is the transform of the receiver's half-ellipse response.
double periodic_trapezoid(double x) noexcept {
  constexpr int kPoints = 96;
  double sum = 0.0;
  for (int i = 1; i < kPoints; ++i) {
    const double t = kPi * i / kPoints;
    const double s = std::sin(t);
    sum += s * s * std::cos(x * std::cos(t));
  }
  return 2.0 * sum / kPoints;
}

// Hankel's expansion of J1 for large arguments (A&S 9.2.5 with mu = 4), cut where it is below 1e-12 from x = 60 on.
double asymptotic(double x) noexcept {
  const double y = 1.0 / (8.0 * x);
  const double y2 = y * y;
  const double p = 1.0 + y2 * (7.5 - y2 * 590.625);
  const double q = y * (3.0 - y2 * (52.5 - y2 * 9095.625));
  const double chi = x - 0.75 * kPi;
  return 2.0 / x * std::sqrt(2.0 / (kPi * x)) * (p * std::cos(chi) - q * std::sin(chi));
}

}  // namespace

double piston_directivity(double x) noexcept {
  const double magnitude = std::abs(x);
  if (!(magnitude < kAsymptoticLimit)) return std::isfinite(x) ? asymptotic(magnitude) : 0.0;
  return magnitude < kSeriesLimit ? series(magnitude) : periodic_trapezoid(magnitude);
}

}  // namespace echoway
