#include <gtest/gtest.h>

#include <cmath>

#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/hall_with_cupboards.hpp"

namespace echoway::tracker {
namespace {

struct AfterAWalk {
  double off;     // Metres along the hall.
  double sigma;
};

// Who is told the start walks two metres towards a cupboard that stands before a hall's end.
AfterAWalk after_a_walk(std::uint64_t seed) {
  constexpr double kFrom = 4.0, kSpeed = 0.5, kTo = 6.0, kStep = 0.6;
  const test::HallWithCupboards hall{.length = 12.0, .cupboards = 11.5, .answer = degrees(10.0)};
  const Building plan = hall.plan();
  const Start start{.room = 0, .position = Vec2{kFrom, 0.5 * hall.kWidth}, .heading = 0.0};
  BayesLocator locator(plan, hall.belt, start, {.seed = seed});
  double x = kFrom, next_step = kFrom + kStep;
  for (int i = 0; x < kTo; ++i) {
    const double time = i * hall.belt.slot_s;
    x = kFrom + kSpeed * time;
    locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    if (x > next_step) {
      locator.on_motion({time, MotionKind::step, 1.0});
      next_step += kStep;
    }
    const int sensor = i % hall.belt.sensors;
    locator.on_firing({time, sensor, hall.heard(sensor, x)});
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
