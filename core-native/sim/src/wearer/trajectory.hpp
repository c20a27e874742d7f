#pragma once

#include <vector>

#include "echoway/result.hpp"
#include "echoway/sim/walk.hpp"
#include "plan/floor_plan.hpp"

namespace echoway::sim {

/// The wearer at one instant.
struct Moment {
  double time_s = 0.0;
  RoomIndex room = kNoRoom;
  Pose2 pose{};            ///< Axis and chest, in the room's frame.
  double yaw = 0.0;        ///< The chest's heading in the level's frame, unwrapped: what a gyroscope integrates to.
  double speed = 0.0;
  double stride = 0.0;     ///< Phase of the gait, radians; a step is half a turn.
};

/// The whole walk, densely sampled.
class Trajectory {
 public:
  /// Fails when the walk names a room that does not exist or a place that cannot be reached.
  static Result<Trajectory> follow(const FloorPlan& plan, const Walk& walk, Random random);

  [[nodiscard]] Moment at(double time_s) const;
  [[nodiscard]] const std::vector<Moment>& samples() const noexcept { return samples_; }
  [[nodiscard]] double duration() const noexcept { return samples_.back().time_s; }

  static constexpr double kStep = 0.01;  ///< Seconds between samples.

 private:
  std::vector<Moment> samples_;
};

}  // namespace echoway::sim
