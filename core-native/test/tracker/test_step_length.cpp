// Steps are counted, not measured: their length is learnt, and how fast they follow then tells how fast one walks.
#include <gtest/gtest.h>

#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/plans.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

constexpr double kShortStep = 0.35, kUsualStep = 0.65, kLongStep = 0.9;   // Metres.
constexpr double kPace = 0.5;                                             // m/s, of all of these wearers.
constexpr double kLearnt = 30.0;                                          // Seconds.
constexpr std::size_t kHalfASecond = 8;                                   // Firings.
constexpr std::uint64_t kWalks = 4;

sim::Simulation walk_with_steps_of(double metres, const Building& building, std::uint64_t seed) {
  sim::RandomWalkOptions options;
  options.duration_s = 2.0 * kLearnt;
  options.speed_mps = kPace;
  options.profile = sim::Profile::empty;
  sim::Walk plan = sim::random_walk(building, options, seed);
  plan.world.step_length_m = metres;
  return *sim::simulate(building, plan);
}

/// Of what a tracker says after kLearnt.
class Mean {
 public:
  [[nodiscard]] double error_m() const { return error_m_ / firings_; }
  /// Of the wearer while they walk.
  [[nodiscard]] double speed_mps() const { return speed_mps_ / walking_; }

  void add(const Building& building, const sim::Simulation& walk, std::size_t i, const Estimate& e) {
    const auto on_level = [&](RoomIndex room, Vec2 at) { return building.room(room).frame.transform(at); };
    const auto truth = [&](const TruthRow& row) { return on_level(building.find_room(row.room), row.pose.position); };
    const TruthRow& now = walk.truth[i];
    if (now.time_s < kLearnt) return;
    error_m_ += distance(on_level(e.room, e.pose.position), truth(now));
    ++firings_;
    const TruthRow& before = walk.truth[i - kHalfASecond];
    if (distance(truth(before), truth(now)) < 0.8 * kPace * (now.time_s - before.time_s)) return;
    speed_mps_ += e.speed_mps;
    ++walking_;
  }

 private:
  double error_m_ = 0.0, speed_mps_ = 0.0;
  int firings_ = 0, walking_ = 0;
};

Mean follow_with_steps_of(double metres) {
  const Building building = test::small_office();
  Mean mean;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    const auto walk = walk_with_steps_of(metres, building, seed);
    BayesLocator locator(building, walk.scans.belt.apply_to({}), test::start_of(walk, building), {.seed = seed});
    test::play(walk, locator, [&](std::size_t i) { mean.add(building, walk, i, locator.estimate()); });
  }
  return mean;
}

// A tracker that takes all steps to be of usual length errs by a fifth to a half more, and by 13 to 18 % in speed.
TEST(StepLength, IsLearntSoThatShortAndLongStridesTellThePaceAsWell) {
  const double usual_error_m = follow_with_steps_of(kUsualStep).error_m();
  for (const double metres : {kShortStep, kLongStep}) {
    const Mean mean = follow_with_steps_of(metres);
    EXPECT_NEAR(mean.speed_mps(), kPace, 0.1 * kPace) << "with steps of " << metres << " m";
    EXPECT_LT(mean.error_m(), 1.2 * usual_error_m) << "with steps of " << metres << " m";
  }
}

}  // namespace
}  // namespace echoway
