#pragma once

#include <vector>

#include "acoustics/echo_paths.hpp"
#include "belt/ballasts.hpp"
#include "belt/faults.hpp"
#include "scene/between_levels.hpp"
#include "scene/floor_world.hpp"
#include "scene/passers_by.hpp"
#include "wearer/trajectory.hpp"

namespace echoway::sim {

/// The worn belt: fires a sensor and says what its ranging module would have said.
class Belt {
 public:
  /// `bearings`: of the sensors, from the chest; config.sensors is not looked at. Plan and world must outlive the belt.
  Belt(const FloorPlan& plan, const BeltConfig& config, std::vector<double> bearings, const World& world,
       Footprint footprint, std::uint64_t seed);

  /// The `index`-th firing. Moments must not go back in time.
  Firing fire(const Moment& moment, int sensor, std::int64_t index);

  /// What stands about in a room and stops who walks into it (door leaves give way). In the room's frame.
  [[nodiscard]] const std::vector<Segment>& things(RoomIndex room) { return floor_.scene(room).things; }

  void happens(const Action& action, double now_s);

 private:
  [[nodiscard]] std::optional<double> measure(const Moment& moment, int sensor, Random& random);
  [[nodiscard]] std::optional<double> late_echo(Random& random) const;
  void listen_for_previous(const Sensor& sensor);
  [[nodiscard]] double temperature(const Moment& moment) const;

  const FloorPlan& plan_;
  BeltConfig config_;
  std::vector<double> bearings_;
  const World& world_;
  std::uint64_t seed_;
  Receiver receiver_;
  FloorWorld floor_;
  BetweenLevelsViews between_;
  PassersBy people_;
  Ballasts ballasts_;
  SensorFaults faults_;
  Vec2 warmer_{};  // Unit vector towards the warm end, in the level's frame.
  std::vector<Obstacle> obstacles_;
  std::vector<Arrival> arrivals_;
  std::vector<Arrival> previous_;  // Of the firing before: they may still be on their way.
};

}  // namespace echoway::sim
