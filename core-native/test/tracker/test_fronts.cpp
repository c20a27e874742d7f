#include "tracker/fronts.hpp"

#include <gtest/gtest.h>

#include "tracker/likelihood.hpp"
#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

constexpr RoomIndex kRoom = 3;
constexpr std::uint16_t kWall = 7;

TEST(Fronts, AreKnownOnlyBeforeTheWallWhereSomethingAnswered) {
  Fronts fronts;
  EXPECT_FALSE(fronts.before(kRoom, kWall));
  fronts.note(kRoom, kWall, {0.5, 0.75});
  ASSERT_TRUE(fronts.before(kRoom, kWall));
  EXPECT_NEAR(fronts.before(kRoom, kWall)->depth, 0.5, 0.002);
  EXPECT_NEAR(fronts.before(kRoom, kWall)->chance, 0.75, 1.0 / 255.0);
  EXPECT_FALSE(fronts.before(kRoom, kWall + 1));
  EXPECT_FALSE(fronts.before(kRoom + 1, kWall)) << "the same number is another wall there";
  fronts.forget();
  EXPECT_FALSE(fronts.before(kRoom, kWall));
}

TEST(Fronts, AreTheSurerTheMoreOftenTheyAnswered) {
  Fronts fronts;
  fronts.note(kRoom, kWall, {0.5, 0.6});
  fronts.note(kRoom, kWall, {0.5, 0.6});
  const double twice = fronts.before(kRoom, kWall)->chance;
  EXPECT_GT(twice, 0.6);
  for (int i = 0; i < 100; ++i) fronts.note(kRoom, kWall, {0.5, 0.6});
  EXPECT_GT(fronts.before(kRoom, kWall)->chance, twice);
  EXPECT_LE(fronts.before(kRoom, kWall)->chance, 1.0);
}

TEST(Fronts, FollowWhereTheyAnswerFrom) {
  Fronts fronts;
  fronts.note(kRoom, kWall, {0.4, 1.0});
  for (int i = 0; i < 20; ++i) fronts.note(kRoom, kWall, {0.6, 1.0});
  EXPECT_NEAR(fronts.before(kRoom, kWall)->depth, 0.6, 0.01);
}

TEST(Fronts, ForgetTheWallNotedFirstWhenThereAreTooMany) {
  Fronts fronts;
  for (std::uint16_t wall = 0; wall <= Fronts::kSlots; ++wall) fronts.note(kRoom, wall, {0.5, 1.0});
  EXPECT_FALSE(fronts.before(kRoom, 0));
  for (std::uint16_t wall = 1; wall <= Fronts::kSlots; ++wall) EXPECT_TRUE(fronts.before(kRoom, wall)) << wall;
}

// Who stands 2 m before the wall at x = 0 of a hall and faces it with sensor 0, as who is followed. A cupboard half a
// metre deep stands before it.
class CupboardsBeforeAWall : public ::testing::Test {
 protected:
  static constexpr double kDepth = 0.5;

  CupboardsBeforeAWall() : hall_(test::plain_hall()), model_(belt_, wary({})), scene_(hall_, model_.sight_limits()) {}

  Particle at(double metres) const {
    Particle p;
    p.room = 0;
    p.position = {metres, 1.5};
    p.heading = kPi;
    face_heading(p);
    p.cov.xx = p.cov.yy = 0.01;
    p.cov.kk = 1e-6;
    return p;
  }

  // What sensor 0 hears from a cupboard's face whoever stands so far before the wall.
  Shot cupboard_heard_at(double metres) const {
    Record record;
    record.echo = true;
    record.range = metres - belt_.radius_m - kDepth;
    return shot_of(record, belt_, {1.0, 0.0});
  }

  Particle who_has_heard_it() {
    Particle p = at(2.0);
    for (int i = 0; i < 3; ++i) {
      assimilate(p, cupboard_heard_at(2.0), model_, scene_);
      p.position = {2.0, 1.5};   // They know where they stand.
      p.cov = at(2.0).cov;
    }
    return p;
  }

  BeltConfig belt_;
  Building hall_;
  EchoModel model_;
  scene::Scene scene_;
};

TEST_F(CupboardsBeforeAWall, AreNoSurpriseForWhoHasHeardThemFromElsewhere) {
  Particle knows = who_has_heard_it();
  knows.position = at(1.5).position;
  const double known = weigh(knows, cupboard_heard_at(1.5), model_, scene_).density;
  EXPECT_GT(known, 1.5 * weigh(at(1.5), cupboard_heard_at(1.5), model_, scene_).density);
}

TEST_F(CupboardsBeforeAWall, TellWhoHasHeardThemHowFarTheyHaveCome) {
  Particle knows = who_has_heard_it();
  knows.position = {1.7, 1.5};   // They think; they stand a little nearer.
  Particle new_here = at(1.7);
  assimilate(knows, cupboard_heard_at(1.6), model_, scene_);
  assimilate(new_here, cupboard_heard_at(1.6), model_, scene_);
  EXPECT_LT(knows.position.x, 1.68);
  EXPECT_GT(knows.position.x, 1.58);
  EXPECT_NEAR(new_here.position.x, 1.7, 0.005) << "it may be half a metre deep, or not quite";
}

TEST_F(CupboardsBeforeAWall, SayNothingForThePlan) {
  Particle knows = who_has_heard_it();
  const Outcome known = weigh(knows, cupboard_heard_at(2.0), model_, scene_);
  const Outcome unknown = weigh(at(2.0), cupboard_heard_at(2.0), model_, scene_);
  EXPECT_NEAR(known.plan, unknown.plan, 1e-9) << "or who is lost would feel at home among what they remember";
  EXPECT_LE(known.mapped, unknown.mapped);
}

}  // namespace
}  // namespace echoway::tracker
