// Where a wearer is who has met the frame of a doorway.
#include "guidance/met_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/plans.hpp"

namespace echoway::guidance {
namespace {

/// Bound from room 0 through the door at (4, 2) of its right wall.
class MetFrameTest : public ::testing::Test {
 protected:
  MetFrameTest() { way.lead_to(*router.tree_to({Goal::Kind::spot, 0, {1, {3.0, 2.0}}}, {})); }

  /// Stands there after a walk.
  void stop_at(Vec2 position, double heading_deg) {
    here.room = 0;
    here.pose = {position, degrees(heading_deg)};
    here.sigma_m = 0.1;
    here.state = TrackState::tracking;
    frame.watch(here, true);
    here.time_s += 2.0;
    ASSERT_TRUE(way.find(here));
  }
  [[nodiscard]] bool meet() {
    const View view{.estimate = &here, .now = here.time_s};
    return frame.meet(view, way);
  }
  /// How far left of where the tracker has them.
  [[nodiscard]] double aside() const { return frame.place(here).pose.position.y - here.pose.position.y; }

  Building rooms = test::make_grid(2, 1, 4.0);
  Router router{rooms};
  GuideConfig config;
  Way way{router, config};
  HeardSpace heard{config.belt};
  MetFrame frame{router, config, heard};
  Estimate here;
};

TEST_F(MetFrameTest, WhoWalkedAslantHasMetTheJambThatTheyWalkedTo) {
  for (const double side : {1.0, -1.0}) {
    frame.forget();
    stop_at({3.6, 2.0}, side * 20.0);
    ASSERT_TRUE(meet());
    EXPECT_GT(side * aside(), 0.1) << side;
  }
}

TEST_F(MetFrameTest, WhoMeetsItAgainIsSoonTakenToBeOnTheOtherSide) {
  stop_at({3.6, 2.0}, 5.0);
  ASSERT_TRUE(meet());
  ASSERT_GT(aside(), 0.1);
  // They are led to the right and meet it there too.
  for (int i = 0; i < 3 && aside() > 0.0; ++i) {
    stop_at({3.6, 1.6}, 0.0);
    here = frame.place(here);
    ASSERT_TRUE(meet());
    here.pose.position = {3.6, 1.6};
  }
  EXPECT_LT(aside(), -0.1);
}

TEST_F(MetFrameTest, NobodyHasMetItWhoWasNotAboutToGoThrough) {
  stop_at({3.6, 2.0}, 90.0);
  EXPECT_FALSE(meet()) << "they walked along the wall";
  stop_at({2.0, 2.0}, 0.0);
  EXPECT_FALSE(meet()) << "it is two metres away";
}

TEST_F(MetFrameTest, WhoStandsBesideTheDoorHearsTheWallThatThePlanHasThere) {
  const auto hears_wall_from = [&](Vec2 position, double heading_deg) {
    heard.clear();
    stop_at(position, heading_deg);
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = 0; i < config.belt.sensors; ++i) heard.on_firing({here.time_s - 0.9 + 0.4 * pass, i, 0.27});
    }
    const View view{.estimate = &here, .now = here.time_s};
    return frame.hear(view, way);
  };
  EXPECT_FALSE(hears_wall_from({3.6, 1.4}, 30.0)) << "about to go through, but not before the opening yet";
  EXPECT_EQ(aside(), 0.0);
  EXPECT_TRUE(hears_wall_from({3.6, 2.0}, 0.0));
}

TEST_F(MetFrameTest, WhatWasFoundHoldsNoLongerOnceThePlaceMovesThoughTheyStand) {
  stop_at({3.6, 2.0}, 20.0);
  frame.watch(here, false);
  ASSERT_TRUE(meet());
  ASSERT_GT(aside(), 0.1);
  here.pose.position.y += 0.3;
  frame.watch(here, false);
  EXPECT_EQ(aside(), 0.0);
}

}  // namespace
}  // namespace echoway::guidance
