#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "echoway/tracker/bayes_locator.hpp"
#include "echoway/units.hpp"
#include "tracker/hall_with_cupboards.hpp"
#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

/// Of who is told the start, faces along x and walks from there to `to`.
struct Walk {
  Vec2 from;
  double to;
  std::function<double(int sensor, double x)> heard;
};

struct AfterAWalk {
  Vec2 off;       // Of where they are believed to be, metres.
  double sigma;
};

AfterAWalk after(const Walk& walk, const Building& plan, const BeltConfig& belt, std::uint64_t seed) {
  constexpr double kSpeed = 0.5, kStep = 0.6;
  BayesLocator locator(plan, belt, {.room = 0, .position = walk.from, .heading = 0.0}, {.seed = seed});
  double x = walk.from.x, next_step = x + kStep;
  for (int i = 0; x < walk.to; ++i) {
    const double time = i * belt.slot_s;
    x = walk.from.x + kSpeed * time;
    locator.on_motion({time, MotionKind::yaw_rate, 0.0});
    if (x > next_step) {
      locator.on_motion({time, MotionKind::step, 1.0});
      next_step += kStep;
    }
    const int sensor = i % belt.sensors;
    locator.on_firing({time, sensor, walk.heard(sensor, x)});
  }
  const Estimate& estimate = locator.estimate();
  return {estimate.pose.position - Vec2{x, walk.from.y}, estimate.sigma_m};
}

TEST(Furniture, BeforeTheEndOfAHallIsNotSurelyTakenForItsEnd) {
  const test::HallWithCupboards hall{.length = 12.0, .cupboards = 11.5, .answer = degrees(10.0)};
  const Walk towards_it{{4.0, 0.5 * hall.kWidth}, 6.0, [&](int sensor, double x) { return hall.heard(sensor, x); }};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const AfterAWalk walk = after(towards_it, hall.plan(), hall.belt, seed);
    EXPECT_LT(std::abs(walk.off.x), 2.0 * walk.sigma) << seed;
  }
}

// The wall on the left stands full of cupboards; the one on the right is hung with curtains and silent.
TEST(Furniture, AllAlongAWallIsNotSurelyTakenForTheWall) {
  constexpr double kLength = 7.0, kWidth = 5.0, kDepth = 0.45, kBeam = degrees(13.0);
  Building plan;
  plan.rooms.push_back(test::room_from_outline("room", {{0, 0}, {kLength, 0}, {kLength, kWidth}, {0, kWidth}}));
  const BeltConfig belt;
  const Vec2 from{1.5, 3.2};
  const auto heard = [&](int sensor, double x) {
    const double bearing = wrap_angle(belt.bearing(sensor));
    if (std::abs(bearing - 0.5 * kPi) < kBeam) return kWidth - kDepth - from.y - belt.radius_m;
    if (std::abs(bearing) < kBeam) return kLength - x - belt.radius_m;
    return std::abs(bearing) > kPi - kBeam ? x - belt.radius_m : Firing::kNoEcho;
  };
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const AfterAWalk walk = after({from, 5.5, heard}, plan, belt, seed);
    EXPECT_LT(std::abs(walk.off.y), 2.0 * walk.sigma) << seed;
  }
}

}  // namespace
}  // namespace echoway::tracker
