#pragma once

#include <memory>
#include <vector>

#include "belt/belt.hpp"
#include "echoway/guidance/advise.hpp"
#include "echoway/sim/world.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "level_crossing.hpp"
#include "plan/floor_plan.hpp"
#include "support/blind_walk.hpp"

namespace echoway::proof {

/// The whole chain: the simulated world's echoes and the phone's motion hints, the tracker, the guide. The world and
/// the tracker's model share no code.
class TrackedPose : public test::PoseSource {
 public:
  /// `route`: what is kept free of furniture. `start`: what the tracker is told. With `truth`, the guide gets that
  /// noisy truth instead of the tracker's estimates, and the echoes only for what stands in the way.
  TrackedPose(const Router& router, const sim::World& world, const Route& route, const Start& start, std::uint64_t seed,
              std::unique_ptr<test::NoisyTruth> truth = nullptr);

  [[nodiscard]] std::vector<Segment> things(RoomIndex room) override { return belt_.things(room); }

  void observe(double time_s, RoomIndex room, const Pose2& pose, double speed, Guide& guide) override;
  void observe_between(double time_s, const test::Crossing& crossing, Guide& guide) override;
  bool heed(Guide& guide) override { return advise(locator_, guide); }

  /// Distance between estimate and truth, metres, of every observation while the room was right.
  [[nodiscard]] const std::vector<double>& errors() const noexcept { return errors_; }
  /// What the tracker thought at a firing, beside the truth.
  struct Entry {
    double time_s = 0.0;
    RoomIndex room = kNoRoom;
    Pose2 pose{};
    Estimate estimate{};
  };
  [[nodiscard]] const std::vector<Entry>& diary() const noexcept { return diary_; }
  /// Share of the observations in which the room was right.
  [[nodiscard]] double room_right() const noexcept;

 private:
  void sense_motion(double time_s, double turned, double steps);
  void fire(const sim::Moment& moment, Guide& guide);

  const Building& building_;
  sim::World world_;
  BeltConfig config_;
  sim::FloorPlan plan_;
  sim::Belt belt_;
  BayesLocator locator_;
  std::unique_ptr<test::NoisyTruth> truth_;
  Random random_;
  std::int64_t index_ = 0;
  double last_time_ = 0.0;
  double last_heading_ = 0.0;  ///< In the level's frame.
  double steps_ = 0.0;
  double yaw_ = 0.0;
  double crossing_since_ = -1.0;
  LevelCrossing crossing_;
  LevelCrossing::Moment last_crossed_{};
  std::vector<double> errors_;
  std::vector<Entry> diary_;
  std::size_t observations_ = 0;
};

}  // namespace echoway::proof
