#include "echoway/scene/scene_report.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "echoway/session.hpp"
#include "support/plans.hpp"

namespace echoway {
namespace {

SceneReport report_of(Building building) { return (*Session::open(std::move(building), {}))->report_scene(); }

// Three rooms of 4 m in a row, joined by doors in the middle of their common walls, and a bench in the third.
Building rooms_with_bench(const Segment& bench) {
  Building b = test::make_grid(3, 1, 4.0);
  b.rooms[2].reflectors.push_back(bench);
  return b;
}

TEST(SceneReport, ABenchThatNoSoundReachesThroughBothDoorsIsLeftOut) {
  const SceneReport report = report_of(rooms_with_bench({{0.1, 0.2}, {0.1, 0.8}}));
  EXPECT_EQ(report.rooms[0].heard.all_reflective, 0U);
  EXPECT_EQ(report.rooms[1].heard.all_reflective, 1U);   // From the doorway.
  EXPECT_EQ(report.rooms[2].heard.all_reflective, 1U);
}

TEST(SceneReport, ABenchOppositeTheDoorsIsHeardTwoRoomsAway) {
  EXPECT_EQ(report_of(rooms_with_bench({{1.0, 1.6}, {1.0, 2.4}})).rooms[0].heard.all_reflective, 1U);
}

TEST(SceneReport, DoorsAreIgnoredWhereNobodyCanLeaveTheRoom) {
  Building b = test::make_grid(2, 1, 4.0);
  const SceneReport joined = report_of(b);
  EXPECT_GT(joined.rooms[0].plain_floor, 0.3);
  EXPECT_LT(joined.rooms[0].plain_floor, 1.0);
}

TEST(SceneReport, LevelsCountOnceThereAreTwo) {
  Building b = test::make_grid(2, 1, 4.0);
  EXPECT_FALSE(report_of(b).levels);
  b.doors.clear();
  b.rooms[1].level = 1;
  EXPECT_TRUE(report_of(std::move(b)).levels);
}

TEST(SceneReport, AFiringLooksAtLittleOfWhatTheRoomHas) {
  const SceneReport report = report_of(test::make_grid(4, 4));
  for (const RoomSavings& r : report.rooms) {
    EXPECT_LE(r.heard.total(), r.within_reach.total());
    EXPECT_LE(r.listed, static_cast<double>(r.heard.total()));
    EXPECT_LT(r.looked_at, 0.5 * r.listed);
    EXPECT_LT(r.sight_tests, 0.5 * r.looked_at * static_cast<double>(r.sight_blockers));
  }
  // Each room's four walls, cut by two to four doors, and the jambs of these.
  EXPECT_EQ(report.sources, 16U * 4U + 48U + 2U * 48U);
}

}  // namespace
}  // namespace echoway
