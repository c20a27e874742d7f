#pragma once

#include <set>
#include <vector>

#include "echoway/result.hpp"
#include "echoway/sim/walk.hpp"
#include "plan/floor_plan.hpp"
#include "scene/between_levels.hpp"

namespace echoway::sim {

/// The wearer at one instant.
struct Moment {
  double time_s = 0.0;
  RoomIndex room = kNoRoom;
  Pose2 pose{};          ///< Axis and chest, in the room's frame.
  double yaw = 0.0;      ///< What a gyroscope integrates to: the chest's heading, unwrapped, but for being carried.
  double heading = 0.0;  ///< The chest's heading in the level's frame.
  double speed = 0.0;
  double stride = 0.0;  ///< Phase of the gait, radians; a step is half a turn.
  BetweenLevels between{};  ///< On stairs or in an elevator; `room` and `pose` then are those of the nearer end.

  /// Axis and chest in the frame of what can be heard.
  [[nodiscard]] const Pose2& heard_from() const noexcept { return between.present ? between.pose : pose; }
};

/// How far limbs and trunk swing at that speed (m/s), as a share of an ordinary walk's: 0 ... 1.
[[nodiscard]] double gait_of(double speed) noexcept;

/// Something that happens to the belt or the building while the wearer walks.
struct Event {
  double time_s = 0.0;
  const Action* action = nullptr;
};

/// The whole walk, densely sampled.
class Trajectory {
 public:
  /// Fails, with the walk's file and line, when the walk names a room that does not exist or a place that cannot be
  /// reached. `walk` must outlive the trajectory.
  static Result<Trajectory> follow(const FloorPlan& plan, const Walk& walk, Random random);

  [[nodiscard]] Moment at(double time_s) const;
  [[nodiscard]] const std::vector<Moment>& samples() const noexcept { return samples_; }
  [[nodiscard]] const std::vector<Event>& events() const noexcept { return events_; }
  [[nodiscard]] double duration() const noexcept { return samples_.back().time_s; }

  /// Doors (indices into Building::doors) that the wearer passes or the walk opens or shuts.
  [[nodiscard]] const std::set<std::size_t>& doors_used() const noexcept { return doors_used_; }

  static constexpr double kStep = 0.01;  ///< Seconds between samples.

 private:
  friend class Walker;
  std::vector<Moment> samples_;
  std::vector<Event> events_;
  std::set<std::size_t> doors_used_;
};

/// The doors between two rooms.
[[nodiscard]] std::vector<std::size_t> doors_between(const Building& building, RoomIndex a, RoomIndex b);

}  // namespace echoway::sim
