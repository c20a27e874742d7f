#pragma once

#include <cstdint>
#include <string_view>

#include "echoway/random.hpp"
#include "echoway/units.hpp"

namespace echoway::sim {

/// Everything about a simulated world that the floor plan does not say and no estimator is told. The defaults are an
/// ordinary furnished building on an ordinary day (docs/simulator.md explains every one and where its value is from).
struct World {
  // Transducer and receiver.
  double transducer_radius_m = 0.0192;   ///< Of the vibrating disc; 38.4 mm across in the Polaroid 600 series.
  double frequency_hz = 49400.0;
  double plane_margin_db = 24.0;         ///< By how much an echo of a plane wall 2 m off, on the axis, tops the threshold.
  double absorption_db_per_m = 1.6;      ///< Of air, along the path.
  double range_noise = 0.01;             ///< Standard deviation, share of the range.
  double timer_tick_s = 12.8e-6;         ///< Of the timer that measures the time of flight.

  // Air. The belt computes ranges with the speed of sound at 20 degrees.
  double temperature_c = 22.0;

  // Surfaces.
  double reflectivity = 0.9;             ///< Mean amplitude left after a bounce off a wall.
  double edge_gain_db = 14.0;            ///< Door jambs and convex corners above the ideal edge: mouldings, rounding.
  bool mirror_paths = true;              ///< Echoes by way of a wall that is not met squarely.

  // What stands about, in no plan.
  double furniture_per_m2 = 0.05;        ///< Cupboards, desks, sofas.
  double posts_per_m2 = 0.03;            ///< Lamp stands, chair and table legs.

  // The wearer.
  double arms = 1.0;                     ///< Share of the time that the arms swing beside the belt, 0 ... 1.
  double yaw_sway_rad = degrees(3.0);    ///< Amplitude of the chest's turning with each stride.
  double side_sway_m = 0.02;             ///< Amplitude of the weaving from side to side.
  double speed_variation = 0.05;         ///< Slow changes of walking speed, standard deviation as a share.

  // Firings that go wrong.
  double dropout = 0.03;                 ///< Share of echoes lost for no reason.
  double ghost = 0.01;                   ///< Share of firings that report something that is not there.

  // The phone's own sensors.
  double step_length_m = 0.65;
  double step_missed = 0.05;             ///< Share of steps that the detector does not see.
  double step_invented_per_s = 0.02;     ///< Steps reported that nobody made.
  double step_delay_s = 0.3;             ///< Longest delay of a step event.
  double gyro_bias_rad_s = degrees(0.5);
  double gyro_noise_rad_s = degrees(0.5);
  double gyro_rate_hz = 25.0;
  bool gyro = true;
  bool steps = true;
  bool heading = false;                  ///< Also report an absolute, drifting heading.
  double heading_offset_rad = degrees(8.0);
  double heading_drift_rad_s = degrees(0.05);
};

/// Named severities.
enum class Profile : std::uint8_t {
  empty,      ///< Bare rooms, nobody about; arms, noise and the odd drop-out remain.
  furnished,  ///< The default: as in real life.
  hard,       ///< Cluttered rooms, people about, many ghosts and drop-outs.
};

[[nodiscard]] World make_world(Profile profile);

/// `profile` with every nuisance parameter drawn from the range in which real belts, rooms and wearers lie, so that
/// nothing is tuned to one world.
[[nodiscard]] World random_world(Profile profile, Random& random);

}  // namespace echoway::sim
