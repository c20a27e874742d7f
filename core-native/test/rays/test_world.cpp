#include "rays/world.hpp"

#include <gtest/gtest.h>

namespace echoway::rays {
namespace {

constexpr Vec2 kEye{0.0, 0.0};
constexpr Vec2 kAhead{1.0, 0.0};
constexpr Segment kWall{{2.0, -1.0}, {2.0, 1.0}};

/// Share of many firings ahead that read between these ranges.
double share_between(double low, double high, const Things& things, Vec2 axis = kAhead) {
  constexpr int kFirings = 400;
  World world(things, Random(5));
  int between = 0;
  for (int i = 0; i < kFirings; ++i) {
    const double range = world.fire(kEye, axis, 0.06);
    between += range > low && range < high ? 1 : 0;
  }
  return static_cast<double>(between) / kFirings;
}

Things wall() {
  Things things;
  things.planes = {kWall};
  things.walls = 1;
  return things;
}

TEST(RayWorld, AWallIsReadWhereItStands) {
  EXPECT_GT(share_between(1.85, 2.15, wall()), 0.8);
  EXPECT_LT(share_between(1.85, 2.15, wall(), {-1.0, 0.0}), 0.05) << "behind the belt";
  EXPECT_LT(share_between(1.85, 2.15, wall(), unit_from_angle(degrees(25.0))), 0.05) << "beside the beam";
}

TEST(RayWorld, WhatStandsBeforeAWallIsReadInItsPlace) {
  Things things = wall();
  things.benches = {{{1.2, -0.4}, {1.2, 0.4}}};
  EXPECT_GT(share_between(1.1, 1.3, things), 0.5);
  EXPECT_LT(share_between(1.85, 2.15, things), 0.05);
}

TEST(RayWorld, AWallIsReadByWayOfAnother) {
  Things things = wall();
  // From here sound meets the first wall aslant and the second one squarely, 1 m farther on.
  const Segment mirror{{1.5, -0.6}, {2.5, 0.4}};
  things.planes = {mirror, {{1.6, 1.0}, {2.4, 1.0}}};
  things.walls = 2;
  EXPECT_GT(share_between(2.85, 3.2, things), 0.1);
}

TEST(RayWorld, NothingOfTheFurnitureStandsInTheWay) {
  Building building;
  Room room;
  room.walls = {{{0.0, 0.0}, {8.0, 0.0}}, {{8.0, 0.0}, {8.0, 5.0}}, {{8.0, 5.0}, {0.0, 5.0}}, {{0.0, 5.0}, {0.0, 0.0}}};
  building.rooms = {room};
  Random random(3);
  std::vector<Vec2> way;
  for (int i = 0; i <= 60; ++i) way.push_back({1.0 + 0.1 * i, 2.5});
  const Things things = furnish(building, way, random);
  ASSERT_GT(things.planes.size(), things.walls) << "no cupboard at all";
  for (const Vec2 at : way) {
    for (std::size_t i = things.walls; i < things.planes.size(); ++i) EXPECT_GT(distance(things.planes[i], at), 0.3);
    for (const Disc& post : things.posts) EXPECT_GT(distance(post.centre, at), 0.3);
  }
}

}  // namespace
}  // namespace echoway::rays
