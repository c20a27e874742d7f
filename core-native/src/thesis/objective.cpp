#include "thesis/objective.hpp"

namespace echoway::thesis {
namespace {

double weight_of(ElementKind kind, const ThesisParameters& parameters) noexcept {
  if (kind == ElementKind::wall) return parameters.wall_weight;
  if (kind == ElementKind::reflector) return parameters.reflector_weight;
  return parameters.corner_weight;
}

}  // namespace

void PositionEchoes::reserve(int directions) {
  const auto n = static_cast<std::size_t>(directions);
  echoes_.reserve(n);
  simulated_.reserve(2 * n);
}

PositionEchoes::Simulated PositionEchoes::describe(const PredictedEcho& echo) const noexcept {
  const double lone = parameters_.corner_weight;
  if (echo.kind == ElementKind::none) {
    return {0.0, 0.0, parameters_.unexplained_m > 0.0 ? lone : 0.0, 0.0, lone * parameters_.unexplained_m, 0.0};
  }
  const double weight = weight_of(echo.kind, parameters_);
  return {echo.range_m, weight, weight, parameters_.unheard_m > 0.0 ? lone : 0.0, 0.0, lone * parameters_.unheard_m};
}

void PositionEchoes::simulate(const RangeModel& model, Vec2 position, const Directions& directions) {
  const auto n = static_cast<std::size_t>(directions.count());
  echoes_.resize(n);
  simulated_.resize(2 * n);
  model.sweep(position, directions, echoes_);
  for (std::size_t k = 0; k < n; ++k) simulated_[k] = simulated_[k + n] = describe(echoes_[k]);
}

}  // namespace echoway::thesis
