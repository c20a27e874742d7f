#include <gtest/gtest.h>

#include <cmath>

#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

// A hall that says nothing of the way along it but where it ends, and before that end stands a cupboard.
constexpr double kLength = 12.0, kWidth = 2.4, kCupboard = 0.5;   // Metres.

// What a sensor hears of a wearer who is `x` metres along the hall's middle and looks along it.
double heard(const BeltConfig& belt, int sensor, double x) {
  const double bearing = wrap_angle(belt.bearing(sensor));
  if (std::abs(bearing) < degrees(10.0)) return kLength - kCupboard - x - belt.radius_m;
  const bool beside = std::abs(std::abs(bearing) - 0.5 * kPi) < degrees(13.0);
  return beside ? 0.5 * kWidth - belt.radius_m : Firing::kNoEcho;
}

struct AfterAWalk {
  double off;     // Metres along the hall.
  double sigma;
};

// Who is told the start walks two metres towards the cupboard.
AfterAWalk after_a_walk(std::uint64_t seed) {
  constexpr double kFrom = 4.0, kSpeed = 0.5, kTo = 6.0, kStep = 0.6;
  const BeltConfig belt;
  Building plan;
  plan.rooms.push_back(test::room_from_outline("hall", {{0, 0}, {kLength, 0}, {kLength, kWidth}, {0, kWidth}}));
  BayesLocator locator(plan, belt, {.room = 0, .position = Vec2{kFrom, 0.5 * kWidth}, .heading = 0.0}, {.seed = seed});
  double x = kFrom, next_step = kFrom + kStep;
  for (int i = 0; x < kTo; ++i) {
    const double time = i * belt.slot_s;
    x = kFrom + kSpeed * time;
    locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    if (x > next_step) {
      locator.on_motion({time, MotionKind::step, 1.0});
      next_step += kStep;
    }
    locator.on_firing({time, i % belt.sensors, heard(belt, i % belt.sensors, x)});
  }
  return {locator.estimate().pose.position.x - x, locator.estimate().sigma_m};
}

TEST(Furniture, BeforeTheEndOfAHallIsNotSurelyTakenForItsEnd) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const AfterAWalk walk = after_a_walk(seed);
    EXPECT_LT(std::abs(walk.off), 2.0 * walk.sigma) << seed;
  }
}

}  // namespace
}  // namespace echoway::tracker
