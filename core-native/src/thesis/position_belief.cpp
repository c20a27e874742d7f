#include "thesis/position_belief.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/vec2.hpp"

namespace echoway::thesis {
namespace {

constexpr double kStep = 1e-3;            // metres, for the derivative of a range
constexpr double kLeastMove = 0.01;       // metres; keeps the covariance from closing up
constexpr double kFarthest = 1e3;         // metres; no building is larger
// The mean magnitude of a normal error times this is its standard deviation.
constexpr double kMagnitudeToSigma = 1.2533141373155001;

}  // namespace

double Symmetric2::greatest_eigenvalue() const noexcept {
  const double middle = 0.5 * (xx + yy);
  return middle + hypotenuse(0.5 * (xx - yy), xy);
}

Symmetric2 Symmetric2::inverse() const noexcept {
  const double determinant = xx * yy - xy * xy;
  return {yy / determinant, -xy / determinant, xx / determinant};
}

Symmetric2 Symmetric2::rotated(double angle) const noexcept {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * c * xx - 2.0 * c * s * xy + s * s * yy, c * s * (xx - yy) + (c * c - s * s) * xy,
          s * s * xx + 2.0 * c * s * xy + c * c * yy};
}

void PositionBelief::move(double sigma) noexcept {
  const double most = kFarthest * kFarthest;
  const double variance = std::max(sigma, kLeastMove) * std::max(sigma, kLeastMove);
  covariance_.xx = std::min(covariance_.xx + variance, most);
  covariance_.yy = std::min(covariance_.yy + variance, most);
}

void PositionBelief::observe(const Scan& scan, const Match& match, const RangeModel& model,
                             const ThesisParameters& parameters) noexcept {
  Symmetric2 information = covariance_.inverse();
  const Vec2 at = match.pose.position;
  for (const Reading& reading : scan.readings()) {
    const PredictedEcho here = model.predict(match.pose, reading.sensor);
    const PredictedEcho right = model.predict({at + Vec2{kStep, 0.0}, match.pose.heading}, reading.sensor);
    const PredictedEcho up = model.predict({at + Vec2{0.0, kStep}, match.pose.heading}, reading.sensor);
    const auto same = [&](const PredictedEcho& e) { return e.kind == here.kind && e.index == here.index; };
    if (here.kind == ElementKind::none || !same(right) || !same(up)) continue;
    const Vec2 slope{(right.range_m - here.range_m) / kStep, (up.range_m - here.range_m) / kStep};
    const double noise = model.belt().range_noise * here.range_m;
    const double misfit = kMagnitudeToSigma * match.objective_m;
    const double variance = noise * noise + misfit * misfit + parameters.map_error_m * parameters.map_error_m;
    information = information + Symmetric2{slope.x * slope.x / variance, slope.x * slope.y / variance,
                                           slope.y * slope.y / variance};
  }
  covariance_ = information.inverse();
}

}  // namespace echoway::thesis
