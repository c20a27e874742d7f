#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "echoway/random.hpp"
#include "echoway/units.hpp"

namespace echoway::sim {

/// Everything about a simulated world that the floor plan does not say and no estimator is told. The defaults are an
/// ordinary furnished building on an ordinary day; docs/simulator.md explains every one and where its value is from.
struct World {
  // Transducer and receiver.
  double transducer_radius_m = 0.0163;  ///< Of an even piston with the same beam as the real disc.
  double frequency_hz = 49400.0;
  double plane_margin_db = 27.0;     ///< By how much a plane wall 2 m off, on the axis, tops the threshold.
  double absorption_db_per_m = 1.6;  ///< Of air at 49 kHz, along the path.
  double flutter_db = 1.0;           ///< Standard deviation of an echo's strength: turbulence, breathing, cloth.
  double range_noise = 0.01;         ///< Standard deviation, share of the range.
  double timer_tick_s = 12.8e-6;     ///< Of the timer that measures the time of flight.
  double crosstalk = 0.003;          ///< Share of firings that hear a late echo of the firing before.

  // Air. The belt computes ranges with the speed of sound at 20 degrees.
  double temperature_c = 22.0;
  double temperature_gradient_k_per_m = 0.05;  ///< Across a level, in a direction drawn from the seed.
  double temperature_drift_k_per_min = 0.02;
  bool thermometer = false;  ///< The log's header says the temperature at the start.

  // Surfaces.
  double reflectivity = 0.9;   ///< Mean amplitude left after a bounce off a wall.
  double edge_gain_db = 14.0;  ///< Door jambs and convex corners above the ideal edge: mouldings, rounding.
  double door_casings = 0.7;   ///< Share of doors whose frame stands out from the wall and so makes corners.
  double rough_walls = 0.15;   ///< Share of walls that answer at any incidence: brick, books, curtains.
  bool mirror_paths = true;    ///< Echoes by way of walls that are not met squarely.

  // What stands and goes about, in no plan.
  double furniture_per_m2 = 0.1;  ///< Cupboards, desks, sofas.
  double posts_per_m2 = 0.08;     ///< Lamp stands, chair and table legs.
  double people_per_100m2 = 1.0;
  double doors_shut = 0.2;    ///< Share of the doors that the walk does not use.
  double door_leaves = 0.6;   ///< Share of open doors whose leaf stands in a room.
  double bad_ballasts = 0.0;  ///< Share of rooms whose lights disturb the belt (thesis section 6.2.5, case III).

  // The wearer.
  double arms = 0.5;                   ///< Share of the time that the arms swing beside the belt, 0 ... 1.
  double yaw_sway_rad = degrees(3.0);  ///< Amplitude of the chest's turning with each stride.
  double side_sway_m = 0.02;           ///< Amplitude of the weaving from side to side.
  double speed_variation = 0.05;       ///< Slow changes of walking speed, standard deviation as a share.

  // Firings that go wrong.
  double dropout = 0.03;  ///< Share of echoes lost for no reason.
  double ghost = 0.01;    ///< Share of firings that report something that is not there.

  // The phone's own sensors.
  bool steps = true;
  bool gyro = true;
  bool heading = false;  ///< Also report an absolute, drifting heading.
  double step_length_m = 0.65;
  double step_missed = 0.05;           ///< Share of steps that the detector does not see.
  double step_invented_per_min = 1.0;  ///< Steps reported that nobody made.
  double step_delay_s = 0.3;           ///< Longest delay of a step event.
  double gyro_bias_rad_s = degrees(0.5);
  double gyro_noise_rad_s = degrees(0.5);
  double gyro_rate_hz = 25.0;
  /// Amplitude by which the phone swings about the vertical with each stride, as on a thigh.
  double phone_swing_rad = 0.0;
  double heading_offset_rad = degrees(8.0);
  double heading_drift_rad_s = degrees(0.05);
};

/// One parameter of a World as a walk file and the command line name it.
struct WorldParameter {
  std::string_view name;  ///< With its unit: `yaw_sway_deg`.
  std::variant<double World::*, bool World::*> field;
  double unit;       ///< SI value of one file unit.
  double low, high;  ///< Accepted values, in file units; 0 and 1 for a switch.
  std::string_view help;

  /// In file units.
  [[nodiscard]] double get(const World& world) const;
  void set(World& world, double value) const;
};

/// All of them, in the order of World.
[[nodiscard]] std::span<const WorldParameter> world_parameters();
[[nodiscard]] const WorldParameter* find_world_parameter(std::string_view name);

/// Named severities.
enum class Profile : std::uint8_t {
  empty,      ///< Bare rooms, nobody about; arms, noise and the odd drop-out remain.
  furnished,  ///< The default: as in real life.
  hard,       ///< Cluttered rooms, people about, bad lights, many ghosts and drop-outs.
};

[[nodiscard]] std::string_view to_string(Profile profile) noexcept;
[[nodiscard]] std::optional<Profile> profile_of(std::string_view name) noexcept;

[[nodiscard]] World make_world(Profile profile);

/// `profile` with every nuisance parameter drawn from the range in which real belts, rooms and wearers lie, so that
/// nothing is tuned to one world. Plane walls 2 m off answer within 7 to 13 degrees of their normal.
[[nodiscard]] World random_world(Profile profile, Random& random);

/// No noise, no nuisance and nothing but the plan: for looking at one effect at a time.
[[nodiscard]] World ideal_world();

}  // namespace echoway::sim
