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

/// Two passes in which the sensors within 30 degrees of the chest hear `ahead_m`, and one that looks to `aside_deg`
/// hears `aside_m`.
Heard hear_ahead(double ahead_m, double aside_deg, double aside_m) {
  Heard heard;
  for (int k = 0; k < 2; ++k, heard.now += kPass) {
    for (int i = 0; i < heard.belt.sensors; ++i) {
      const double bearing = wrap_angle(heard.belt.bearing(i));
      const bool aside = std::abs(bearing - degrees(aside_deg)) < degrees(1.0);
      const double straight_m = std::abs(bearing) < degrees(30.0) ? ahead_m : Firing::kNoEcho;
      heard.space.on_firing({heard.now, i, aside ? aside_m : straight_m});
    }
  }
  return heard;
}

TEST(HeardSpace, ItIsOpenWhereAFarWallAnswersAndNothingLiesInTheWay) {
  const auto open = [](const Heard& heard) { return heard.space.is_open(0.0, 1.0, heard.now - kPass); };
  EXPECT_TRUE(open(hear_ahead(2.0, 120.0, 0.5)));
  EXPECT_FALSE(open(hear_ahead(0.7, 120.0, 0.5)));
  EXPECT_FALSE(open(hear_ahead(2.0, 48.0, 0.3))) << "a shoulder would meet it";
  EXPECT_FALSE(open(hear_ahead(Firing::kNoEcho, 48.0, 2.0))) << "a wall too near to be heard is silent too";
}

}  // namespace
}  // namespace echoway::guidance
