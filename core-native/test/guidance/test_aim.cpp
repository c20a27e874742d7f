// Where to head for, close before a doorway.
#include "guidance/aim.hpp"

#include <gtest/gtest.h>

#include "support/plans.hpp"

namespace echoway::guidance {
namespace {

/// Two rooms side by side, 4 m square, a door between their middles; the way leads through it.
class AimTest : public ::testing::Test {
 protected:
  void SetUp() override { way.lead_to(*router.tree_to({Goal::Kind::spot, 0, {1, {3.0, 2.0}}})); }

  [[nodiscard]] Vec2 target_from(const Pose2& pose) {
    Estimate e;
    e.room = 0;
    e.pose = pose;
    e.sigma_m = 0.05;
    e.state = TrackState::tracking;
    EXPECT_TRUE(way.find(e));
    View view{.estimate = &e};
    view.turn = next_manoeuvre(way.line(), config.ahead_rad, config.fuse_m);
    aim.take(view);
    return view.target;
  }

  Building building = test::make_grid(2, 1, 4.0);
  Router router{building};
  GuideConfig config;
  Way way{router, config};
  Reaction reaction{config};
  Aim aim{router, config, way, reaction};
};

TEST_F(AimTest, WhoWouldGoThroughADoorwayAslantGoesRoundWhatStandsThereFirst) {
  const Pose2 beside{{3.4, 1.6}, 0.4};  // close before it and to its right, facing the opening
  const Vec2 through = target_from(beside);
  EXPECT_GT(through.x, 4.0) << "aslant through it";
  way.hindrances().touch(0, beside, 0.3, 0.0);
  const Vec2 post = beside.position + 0.3 * unit_from_angle(beside.heading);
  const Vec2 round = target_from(beside);
  EXPECT_GT(distance(Segment{beside.position, round}, post), 0.2) << round.x << ' ' << round.y;
}

}  // namespace
}  // namespace echoway::guidance
