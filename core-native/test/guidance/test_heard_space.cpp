// What the belt hears about the wearer by itself.
#include "guidance/heard_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/geometry/pose2.hpp"
#include "echoway/units.hpp"

namespace echoway::guidance {
namespace {

constexpr double kPass = 0.94;  // seconds

/// A belt and what it hears.
struct Heard {
  /// One pass in which only the sensor that looks to `bearing` hears something.
  void pass(double bearing, double range_m) {
    for (int i = 0; i < belt.sensors; ++i) {
      const bool looks = std::abs(wrap_angle(belt.bearing(i) - bearing)) < degrees(1.0);
      space.on_firing({now, i, looks ? range_m : Firing::kNoEcho});
    }
    now += kPass;
  }
  [[nodiscard]] std::optional<double> wall(double direction) const { return space.wall(direction, now - kPass); }

  BeltConfig belt;
  HeardSpace space{belt};
  double now = 0.0;
};

TEST(HeardSpace, AWallThatIsHeardAslantIsFartherOnTheWay) {
  Heard heard;
  for (int i = 0; i < 2; ++i) heard.pass(degrees(48.0), 0.2);
  ASSERT_TRUE(heard.wall(0.0));
  EXPECT_NEAR(*heard.wall(0.0), (0.2 + heard.belt.radius_m) / std::cos(degrees(48.0)), 1e-9);
  EXPECT_NEAR(*heard.wall(degrees(48.0)), 0.2 + heard.belt.radius_m, 1e-9);
  EXPECT_FALSE(heard.wall(-kPi / 2)) << "it is on the other side";
}

TEST(HeardSpace, OnlyASteadyEchoIsAWall) {
  Heard heard;
  heard.pass(0.0, 1.2);
  EXPECT_FALSE(heard.wall(0.0)) << "once may be chance";
  heard.pass(0.0, 0.6);
  EXPECT_FALSE(heard.wall(0.0)) << "it moves";
  heard.pass(0.0, 0.6);
  EXPECT_TRUE(heard.wall(0.0));
  heard.now += 3.0;
  EXPECT_FALSE(heard.wall(0.0)) << "long ago";
}

TEST(HeardSpace, HandsAreBesideTheWearerAndNotBeforeThem) {
  Heard heard;
  for (int i = 0; i < 2; ++i) heard.pass(degrees(96.0), 0.2);
  EXPECT_FALSE(heard.wall(degrees(96.0)));
  for (int i = 0; i < 2; ++i) heard.pass(0.0, 0.2);
  EXPECT_TRUE(heard.wall(0.0));
}

TEST(HeardSpace, WhatIsHeardToASideIsTheNearestSteadyEchoFromThere) {
  Heard heard;
  for (int i = 0; i < 2; ++i) heard.pass(0.0, 0.3);
  const auto toward = [&](double direction) { return heard.space.toward(direction, heard.now - kPass); };
  ASSERT_TRUE(toward(degrees(10.0)));
  EXPECT_NEAR(*toward(degrees(10.0)), 0.3 + heard.belt.radius_m, 1e-9);
  EXPECT_FALSE(toward(degrees(48.0))) << "it is elsewhere";
  heard.pass(0.0, 0.9);
  EXPECT_FALSE(toward(0.0)) << "it moves";
}

}  // namespace
}  // namespace echoway::guidance
