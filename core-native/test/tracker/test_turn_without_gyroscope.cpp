#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/plans.hpp"

namespace echoway {
namespace {

/// A square hall that looks the same after a quarter turn, and things about its middle that stand in no plan.
class HallOfStrangers {
 public:
  HallOfStrangers() {
    plan_.rooms.push_back(test::room_from_outline("hall", {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}));
  }
  const Building& plan() const { return plan_; }

  /// What a sensor hears that looks this way from the middle.
  double heard(double direction) const {
    for (int thing = 0; thing < kThings; ++thing) {
      const double off = wrap_angle(direction - kTwoPi * thing / kThings);
      if (std::abs(off) < degrees(11.0)) return 1.2 + 0.35 * (thing * 4 % kThings);
    }
    const double off_a_wall = std::abs(std::remainder(direction, 0.5 * kPi));
    return off_a_wall < degrees(8.0) ? 0.5 * kSide - BeltConfig{}.radius_m : Firing::kNoEcho;
  }

 private:
  static constexpr double kSide = 12.0;   // Metres.
  static constexpr int kThings = 9;
  Building plan_;
};

/// How far off the heading is of who stood in the middle and turned by a quarter, with no motion hint at all.
double off_after_a_turn(const BayesOptions& options) {
  const HallOfStrangers hall;
  const BeltConfig belt;
  BayesLocator locator(hall.plan(), belt, {0, Vec2{6.0, 6.0}, 0.0}, options);
  constexpr double kStood = 4.0, kTurned = 1.5, kQuarter = 0.5 * kPi;
  for (int n = 0; n * belt.slot_s < kStood + kTurned + kStood; ++n) {
    const double time = n * belt.slot_s;
    const double heading = kQuarter * std::clamp((time - kStood) / kTurned, 0.0, 1.0);
    const int sensor = n % belt.sensors;
    locator.on_firing({time, sensor, hall.heard(heading + belt.bearing(sensor))});
  }
  return std::abs(wrap_angle(locator.estimate().pose.heading - kQuarter));
}

TEST(TurnWithoutGyroscope, IsToldByThingsThatStandInNoPlan) {
  double with = 0.0, without = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    BayesOptions options;
    options.seed = seed;
    with += off_after_a_turn(options) / 8.0;
    options.parts.repeats = false;
    without += off_after_a_turn(options) / 8.0;
  }
  EXPECT_LT(to_degrees(with), 10.0);
  EXPECT_GT(to_degrees(without), 30.0) << "the walls alone do not tell";
}

}  // namespace
}  // namespace echoway
