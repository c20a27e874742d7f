// Whether an instruction leaves room, wherever the wearer may come to carry it out.
#include "guidance/outlook.hpp"

#include <gtest/gtest.h>

#include "guidance/standing.hpp"
#include "guidance/straight_walk.hpp"
#include "guidance/stretch.hpp"
#include "support/plans.hpp"

namespace echoway::guidance {
namespace {

Estimate at(Vec2 position, double heading_deg, double sigma_m = 0.02) {
  Estimate e;
  e.room = 0;
  e.pose = {position, degrees(heading_deg)};
  e.sigma_m = sigma_m;
  e.sigma_heading_rad = degrees(1.0);
  e.state = TrackState::tracking;
  return e;
}

/// Two rooms side by side, 5 m square, a door between their middles.
class OutlookTest : public ::testing::Test {
 protected:
  [[nodiscard]] bool clear(const Estimate& e, double direction_deg, double pace = 0.0,
                           const Demand& demand = {}) const {
    const View view{.estimate = &e, .pace = pace};
    return outlook.clear_ahead(view, make_cue(CueKind::turn), degrees(direction_deg), demand);
  }

  Building building = test::make_grid(2, 1);
  Router router{building};
  GuideConfig config;
  Hindrances hindrances{config};
  Reaction reaction{config};
  Outlook outlook{router, config, hindrances, reaction};
};

TEST_F(OutlookTest, LessIsSureTheLessThePositionIs) {
  EXPECT_TRUE(clear(at({0.7, 2.5}, 180.0), 0.0));
  EXPECT_FALSE(clear(at({0.7, 2.5}, 180.0, 0.12), 0.0)) << "the wall may be at half a metre";
  EXPECT_TRUE(clear(at({0.7, 2.5}, 180.0, 0.12), 180.0)) << "but not behind";
  EXPECT_TRUE(clear(at({1.5, 2.5}, 180.0, 0.2), 0.0));
  EXPECT_FALSE(clear(at({1.5, 2.5}, 180.0, 0.3), 0.0)) << "a place that is known still less well";
}

TEST_F(OutlookTest, APositionBehindAWallIsTakenToBeBeforeIt) {
  EXPECT_FALSE(clear(at({-0.05, 1.0}, 90.0), 90.0)) << "the wall is on the left";
  EXPECT_TRUE(clear(at({-0.05, 1.0}, 90.0), -90.0));
}

TEST_F(OutlookTest, LessIsSureTheLessTheHeadingIs) {
  Estimate e = at({2.5, 0.32}, 0.0);  // along a wall
  EXPECT_TRUE(clear(e, 0.0));
  e.sigma_heading_rad = degrees(20.0);
  EXPECT_FALSE(clear(e, 0.0, 0.0, {0.95, 2.0}));
}

TEST_F(OutlookTest, WhoWalksOnByThemselvesIsNotTurnedWhereTheyWillHaveCome) {
  const Estimate e = at({1.7, 1.0}, 180.0);
  EXPECT_TRUE(clear(e, 0.0));
  EXPECT_FALSE(clear(e, 0.0, 0.8));
}

TEST_F(OutlookTest, ThingsThatNoPlanKnowsCountUnlessOnlyWallsAreAskedFor) {
  const Estimate e = at({2.0, 1.0}, 0.0);
  hindrances.hear(0, {2.3, 1.0}, 0.0);
  EXPECT_FALSE(clear(e, 0.0));
  EXPECT_TRUE(clear(e, 90.0)) << "it stands ahead only";
  EXPECT_TRUE(clear(e, 0.0, 0.0, {0.5, 1.0, false}));
}

TEST_F(OutlookTest, BeyondADoorwayTheNextRoomIsLookedAt) {
  const Estimate before_door = at({4.6, 2.5}, 0.0);
  EXPECT_TRUE(clear(before_door, 0.0, 0.8, {3.0, 0.0}));
  EXPECT_FALSE(clear(before_door, 0.0, 0.8, {5.0, 0.0}))
      << "they will be a metre inside by then, and its wall is 4 m ahead";
}

TEST_F(OutlookTest, AStraightWalkEndsBeforeAWallAndGoesThroughDoorways) {
  const StraightWalk along(router, 0, {{4.0, 2.5}, 0.0}, 0.25);
  EXPECT_EQ(along.after(0.9).room, 0);
  const StraightWalk::Place beyond = along.after(1.5);
  EXPECT_EQ(beyond.room, 1);
  EXPECT_NEAR(distance(beyond.pose.position, Vec2{0.5, 2.5}), 0.0, 1e-9);
  EXPECT_NEAR(along.after(20.0).pose.position.x, 4.75, 1e-9);
  const StraightWalk to_wall(router, 0, {{4.0, 1.0}, 0.0}, 0.25);
  EXPECT_EQ(to_wall.after(3.0).room, 0);
  EXPECT_NEAR(to_wall.after(3.0).pose.position.x, 4.75, 1e-9);
}

TEST(Standing, WhoStandsIsWhereTheyWereOnTheWhole) {
  Standing standing;
  Estimate settled;
  for (int i = 0; i < 40; ++i) settled = standing.settle(at({2.0 + (i % 2 == 0 ? 0.1 : -0.1), 1.0}, 0.0, 0.1), false);
  EXPECT_NEAR(settled.pose.position.x, 2.0, 0.01) << "one position that errs says little";
  EXPECT_NEAR(standing.settle(at({2.3, 1.0}, 0.0, 0.5), false).pose.position.x, 2.0, 0.01)
      << "still less one that is unsure";
  EXPECT_NEAR(standing.settle(at({3.0, 1.0}, 0.0, 0.1), false).pose.position.x, 3.0, 1e-9) << "they were moved";
  EXPECT_NEAR(standing.settle(at({3.2, 1.0}, 0.0, 0.1), true).pose.position.x, 3.2, 1e-9) << "they walk";
}

/// Room 0 and, from x = 5 on in the same frame of the level, room 1.
class StretchTest : public ::testing::Test {
 protected:
  /// Walked at one metre a second from (4, 2.5) to `x`, of three metres that were told.
  void walk_to(double x) {
    e = at({4.0, 2.5}, 0.0);
    stretch.tell({.estimate = &e, .now = 0.0}, 3.0);
    e.pose.position.x = x;
    now = x - 4.0;
    ASSERT_EQ(stretch.watch({.estimate = &e, .now = now, .walking = true}, 0.0), Stretch::Outcome::open);
  }
  [[nodiscard]] Stretch::Outcome stand_for(double seconds) {
    return stretch.watch({.estimate = &e, .now = now + seconds, .still_since = now}, 0.0);
  }

  Building building = test::make_grid(2, 1);
  Stretch stretch{building};
  Estimate e;
  double now = 0.0;
};

TEST_F(StretchTest, WhoStopsWellShortOfItIsFoundToHaveMetSomethingAfterAMoment) {
  walk_to(4.6);
  EXPECT_EQ(stand_for(0.2), Stretch::Outcome::short_of);
  EXPECT_EQ(stand_for(1.7), Stretch::Outcome::met);
  EXPECT_EQ(stand_for(1.9), Stretch::Outcome::open) << "told once";
}

TEST_F(StretchTest, WhoStopsInADoorwayHasMetItsFrameInWhicheverRoomTheyAreTakenToBe) {
  walk_to(4.9);
  e.room = 1;
  e.pose.position = {0.1, 2.5};
  EXPECT_EQ(stand_for(0.2), Stretch::Outcome::short_of);
  e.room = 0;
  e.pose.position = {4.9, 2.5};
  EXPECT_EQ(stand_for(1.7), Stretch::Outcome::met);
}

TEST_F(StretchTest, WhoStopsSinceTheyAreToldToHasMetNothing) {
  walk_to(4.6);
  stretch.stop(now - 1.2);
  EXPECT_EQ(stand_for(1.7), Stretch::Outcome::open);
}

TEST_F(StretchTest, WhoStandsBeforeTheyCanHaveObeyedHasMetSomething) {
  walk_to(4.6);
  stretch.stop(now - 0.3);
  EXPECT_EQ(stand_for(1.7), Stretch::Outcome::met);
}

}  // namespace
}  // namespace echoway::guidance
