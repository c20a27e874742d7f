#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/thesis/parameters.hpp"
#include "echoway/tracker/bayes_locator.hpp"

namespace echoway::report {

/// One way of estimating, told so much.
struct Estimator {
  std::string name;
  bool thesis = false;
  bool steps = true;
  bool turns = true;  ///< The gyroscope's yaw rates and absolute headings.
  enum class Told { pose, room, nothing } told = Told::pose;
  bool thermometer = false;  ///< Told the air's temperature at the start.
  BayesOptions bayes{};
  ThesisParameters parameters{};
};

[[nodiscard]] Estimator thesis_method();
/// Rooms compared by the objective itself and not by what share of their range it is.
[[nodiscard]] Estimator thesis_by_objective();
/// Objective (5.1) to the letter.
[[nodiscard]] Estimator thesis_as_printed();
[[nodiscard]] Estimator tracker();
/// Echoes alone: no steps, no gyroscope.
[[nodiscard]] Estimator tracker_without_hints();

/// What was walked, and on which plan it is followed.
struct Trial {
  const Building& world;  ///< The rooms of the truth.
  const Building& plan;   ///< What the estimator is told; the same rooms in the same frames.
  const sim::Simulation& walk;
  double temperature_c = kReferenceCelsius;
  std::uint64_t seed = 1;
};

/// An estimate against the truth at the moment that it is about.
struct Fix {
  double time_s = 0.0;
  RoomIndex room = kNoRoom;
  RoomIndex true_room = kNoRoom;
  double error_m = 0.0;   ///< kNowhere while there is no estimate, or one on another level.
  double turn_rad = 0.0;  ///< Error of the heading, signed.
  double sigma_m = 0.0;
  TrackState state = TrackState::searching;

  static constexpr double kNowhere = 20.0;
  [[nodiscard]] bool right() const noexcept { return room == true_room; }
};

struct Track {
  std::vector<Fix> fixes;         ///< One for each renewed estimate.
  std::vector<double> firing_us;  ///< Processor time of each firing.

  /// Mean processor time of a firing; 0 of none.
  [[nodiscard]] double cpu_us() const;
};

/// Follows the walk's firings (all, or those given) with motion hints where the estimator takes them.
[[nodiscard]] Track follow(const Trial& trial, const Estimator& estimator);
[[nodiscard]] Track follow(const Trial& trial, const Estimator& estimator, std::span<const Firing> firings);
/// Until `enough` says so of the newest fix.
[[nodiscard]] Track follow(const Trial& trial, const Estimator& estimator,
                           const std::function<bool(const Fix&)>& enough);

/// Of the fixes at or after `from_s`.
struct Summary {
  double mean_m = 0.0;
  double median_m = 0.0;
  double p90_m = 0.0;
  double turn_rad = 0.0;  ///< Mean magnitude.
  double right_room = 0.0;
  double within_2_sigma = 0.0;
};
[[nodiscard]] Summary summarise(const Track& track, double from_s = 0.0);

/// `share` of the way through the sorted values; NaN of none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace echoway::report
