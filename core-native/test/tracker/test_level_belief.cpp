#include "tracker/level_belief.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

Building two_levels() {
  Building b = test::storeys(2);
  b.links.push_back({LevelLinkKind::stairs, 0, {1.0, 1.0}, 1, {1.0, 1.0}});
  return b;
}

class LevelBeliefTest : public ::testing::Test {
 protected:
  /// The wearer is thought to be in `room`, or on the stairs from there.
  void be_in(RoomIndex room, double seconds, Gait gait = Gait::walking) {
    std::array<Particle, 1> one;
    one[0].weight = 1.0;
    one[0].room = room;
    one[0].gait = gait;
    for (double t = 0.0; t < seconds; t += 0.1) belief.observe(one, links, 0.1);
  }
  [[nodiscard]] bool is_likelier(RoomIndex a, RoomIndex b) const {
    return belief.log_probability(a) > belief.log_probability(b);
  }

  const Building building = two_levels();
  LevelLinks links{building};
  LevelBelief belief{building};
};

TEST_F(LevelBeliefTest, KnowsNothingAtFirst) { EXPECT_EQ(belief.log_probability(0), belief.log_probability(1)); }

TEST_F(LevelBeliefTest, RemembersWhereTheWearerSaysTheyStart) {
  belief.begin_in(1);
  be_in(0, 5.0);
  EXPECT_TRUE(is_likelier(1, 0));
}

TEST_F(LevelBeliefTest, FollowsWhoIsFoundElsewhereForLong) {
  belief.begin_in(1);
  be_in(0, 90.0);
  EXPECT_TRUE(is_likelier(0, 1));
}

TEST_F(LevelBeliefTest, GoesUpTheStairsWithTheWearer) {
  belief.begin_in(0);
  be_in(0, 30.0, Gait::away);
  EXPECT_TRUE(is_likelier(1, 0));
}

TEST_F(LevelBeliefTest, IsNeverSoSureThatEchoesCouldNotProveItWrong) {
  belief.begin_in(0);
  be_in(0, 600.0);
  EXPECT_GT(belief.log_probability(1), -10.0);
}

}  // namespace
}  // namespace echoway::tracker
