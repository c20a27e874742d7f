#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "echoway/acoustics/range_model.hpp"
#include "echoway/thesis/parameters.hpp"
#include "thesis/scan.hpp"

namespace echoway::thesis {

/// How well a pose explains a scan.
struct Score {
  double objective_m = 0.0;  ///< Metres; the less the better.
  int matched = 0;           ///< Sensors that have a reading in both scan and simulation.
};

/// What sensors would read in every direction of a grid from one position, laid out for scoring every heading of that
/// grid against a scan: heading h puts sensor 0 in direction h and sensor i in direction h + i * sensor_step.
class PositionEchoes {
 public:
  explicit PositionEchoes(const ThesisParameters& parameters) : parameters_(parameters) {}

  void reserve(int directions);
  /// Allocates only beyond what has been reserved.
  void simulate(const RangeModel& model, Vec2 position, const Directions& directions);

  /// Objective (5.1), each difference taken as its magnitude (the formula as printed has no bars, but a sum of signed
  /// differences has no minimum), with what ThesisParameters adds to it.
  [[nodiscard]] Score score(const Scan& scan, int heading, int sensor_step) const noexcept {
    double sum = 0.0;
    double weights = 0.0;
    int matched = 0;
    for (const Reading& reading : scan.readings()) {
      const Simulated& simulated = simulated_[static_cast<std::size_t>(heading + reading.sensor * sensor_step)];
      const double difference = std::min(std::abs(reading.range_m - simulated.range), parameters_.mismatch_m);
      sum += simulated.weight * difference + simulated.unexplained;
      weights += simulated.weight_if_real;
      matched += simulated.weight > 0.0 ? 1 : 0;
    }
    for (const int sensor : scan.silent()) {
      const Simulated& simulated = simulated_[static_cast<std::size_t>(heading + sensor * sensor_step)];
      sum += simulated.unheard;
      weights += simulated.weight_if_silent;
    }
    return {weights > 0.0 ? sum / weights : 0.0, matched};
  }

 private:
  // One direction, with all that depends on whether something answers there worked out, so that scoring has no branch.
  struct Simulated {
    double range = 0.0;
    double weight = 0.0;            // 0 where nothing answers
    double weight_if_real = 0.0;
    double weight_if_silent = 0.0;
    double unexplained = 0.0;       // weighted cost of a real reading where nothing answers
    double unheard = 0.0;           // weighted cost of silence where something answers
  };

  [[nodiscard]] Simulated describe(const PredictedEcho& echo) const noexcept;

  ThesisParameters parameters_;
  std::vector<PredictedEcho> echoes_;
  std::vector<Simulated> simulated_;  ///< Twice round, so that no index needs wrapping.
};

}  // namespace echoway::thesis
