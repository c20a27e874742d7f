#include "tracker/likelihood.hpp"

#include <gtest/gtest.h>

#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

// Who stands 2 m before the wall at x = 0 of a hall and faces it with sensor 0.
class LikelihoodTest : public ::testing::Test {
 protected:
  LikelihoodTest() : hall_(test::plain_hall()), model_(belt_, {}), scene_(hall_, model_.sight_limits()) {
    before_wall_.room = 0;
    before_wall_.position = {2.0, 1.5};
    before_wall_.heading = kPi;
    before_wall_.facing = {-1.0, 0.0};
    before_wall_.cov.xx = before_wall_.cov.yy = 0.04;
    before_wall_.cov.kk = 1e-6;
  }

  Shot heard_by(int sensor, double metres) const {
    Record record;
    record.sensor = sensor;
    record.echo = true;
    record.range = metres;
    return shot_of(record, belt_, unit_from_angle(belt_.bearing(sensor)));
  }

  Shot heard_at(double metres) const { return heard_by(0, metres); }

  BeltConfig belt_;
  Building hall_;
  EchoModel model_;
  scene::Scene scene_;
  Particle before_wall_;
};

TEST_F(LikelihoodTest, AnEchoOfAWallNearerThanThoughtMovesWhoListensTowardsIt) {
  Particle listens = before_wall_;
  assimilate(listens, heard_at(1.7), model_, scene_);
  EXPECT_LT(listens.position.x, before_wall_.position.x - 0.05);
  EXPECT_LT(listens.cov.xx, before_wall_.cov.xx);
}

TEST_F(LikelihoodTest, WhoIsInNoRoomStaysWhereTheyAreThought) {
  Particle climbs = before_wall_;
  const Outcome heard = hear_in_no_room(climbs, heard_at(1.7), model_, 0.2);
  EXPECT_EQ(climbs.position, before_wall_.position);
  EXPECT_EQ(climbs.cov.xx, before_wall_.cov.xx);
  EXPECT_EQ(heard.mapped, 0.0);
  EXPECT_DOUBLE_EQ(heard.density, 0.2);
}

TEST_F(LikelihoodTest, WhatAnsweredInNoRoomMayAnswerAgainAndSaysNothingOfThePlan) {
  Particle climbs = before_wall_;
  Shot shot = heard_at(1.7);
  const Repeat again{EchoRepeats::slot_of(shot.sensor), 0.1, 0.0};
  shot.repeats = {&again, 1};
  const Outcome first = hear_in_no_room(climbs, shot, model_, 0.2);
  EXPECT_DOUBLE_EQ(first.density, 0.2) << "as far as is known the echo before came from something in the plan";
  const Outcome second = hear_in_no_room(climbs, shot, model_, 0.2);
  EXPECT_GT(second.density, 1.0);
  EXPECT_DOUBLE_EQ(second.plan, 0.2);
}

TEST_F(LikelihoodTest, FurnitureBeforeAWallIsLessOfASurpriseThanInMidRoom) {
  const EchoModel followed(belt_, wary({}));
  const double before_wall = weigh(before_wall_, heard_at(1.4), followed, scene_).density;
  EXPECT_GT(before_wall, 2.0 * weigh(before_wall_, heard_at(0.9), followed, scene_).density);
  EXPECT_GT(before_wall, 2.0 * weigh(before_wall_, heard_at(2.4), followed, scene_).density) << "nor is it behind it";
}

TEST_F(LikelihoodTest, WhoReckonsWithFurnitureIsMovedLessByIt) {
  const EchoModel followed(belt_, wary({}));
  const auto moved_by = [&](const EchoModel& model) {
    Particle listens = before_wall_;
    assimilate(listens, heard_at(1.5), model, scene_);
    return before_wall_.position.x - listens.position.x;
  };
  EchoModelParameters of_empty_rooms;
  of_empty_rooms.furnished = 0.0;
  EXPECT_LT(moved_by(followed), 0.5 * moved_by(EchoModel(belt_, of_empty_rooms)));
}

// Cupboards half a metre deep stand all along the wall that sensor 0 faces.
class CupboardsBeforeAWall : public LikelihoodTest {
 protected:
  static constexpr double kDepth = 0.5;

  Particle at(double metres) const {
    Particle p = before_wall_;
    p.position.x = metres;
    p.cov.xx = p.cov.yy = 0.01;
    return p;
  }

  // From the cupboards' faces, whoever stands so far before the wall.
  Shot heard_by_who_stands_at(double metres) const { return heard_at(metres - belt_.radius_m - kDepth); }

  Particle who_has_heard_them() {
    Particle p = at(2.0);
    for (int i = 0; i < 3; ++i) {
      assimilate(p, heard_by_who_stands_at(2.0), followed_, scene_);
      p.position = at(2.0).position;   // They know where they stand.
      p.cov = at(2.0).cov;
    }
    return p;
  }

  EchoModel followed_{belt_, wary({})};
};

TEST_F(CupboardsBeforeAWall, AreNoSurpriseForWhoHasHeardThemFromElsewhere) {
  Particle knows = who_has_heard_them();
  knows.position = at(1.5).position;
  const double known = weigh(knows, heard_by_who_stands_at(1.5), followed_, scene_).density;
  EXPECT_GT(known, 1.5 * weigh(at(1.5), heard_by_who_stands_at(1.5), followed_, scene_).density);
}

TEST_F(CupboardsBeforeAWall, TellWhoHasHeardThemHowFarTheyHaveCome) {
  Particle knows = who_has_heard_them();
  knows.position = {1.7, 1.5};   // They think; they stand a little nearer.
  Particle new_here = at(1.7);
  assimilate(knows, heard_by_who_stands_at(1.6), followed_, scene_);
  assimilate(new_here, heard_by_who_stands_at(1.6), followed_, scene_);
  EXPECT_LT(knows.position.x, 1.68);
  EXPECT_GT(knows.position.x, 1.58);
  EXPECT_NEAR(new_here.position.x, 1.7, 0.005) << "it may be half a metre deep, or not quite";
}

TEST_F(CupboardsBeforeAWall, SayNothingForThePlan) {
  Particle knows = who_has_heard_them();
  const Outcome known = weigh(knows, heard_by_who_stands_at(2.0), followed_, scene_);
  const Outcome unknown = weigh(at(2.0), heard_by_who_stands_at(2.0), followed_, scene_);
  EXPECT_NEAR(known.plan, unknown.plan, 1e-9) << "or who is lost would feel at home among what they remember";
  EXPECT_LE(known.mapped, unknown.mapped);
}

// A cupboard that is in no plan answered sensor 1 from 0.8 m, and now something answers sensor 0 from there.
class CupboardTest : public LikelihoodTest {
 protected:
  CupboardTest() { assimilate(before_wall_, heard_by(1, 0.8), model_, scene_); }

  double density(Particle p, double turned, double walked, int sensor, double metres) {
    p.heading += turned;
    p.facing = unit_from_angle(p.heading);
    p.strangers.move(walked * p.facing);
    Shot shot = heard_by(sensor, metres);
    const Repeat again{EchoRepeats::slot_of(1), 0.1, 0.0};
    shot.repeats = {&again, 1};
    return hear_in_no_room(p, shot, model_, 0.05).density;
  }
};

TEST_F(CupboardTest, IsHeardAgainByTheSensorThatATurnBringsBeforeIt) {
  const double turned = density(before_wall_, belt_.bearing(1), 0.0, 0, 0.8);
  EXPECT_GT(turned, 10.0 * density(before_wall_, 0.0, 0.0, 0, 0.8)) << "who has not turned did not expect it there";
}

TEST_F(CupboardTest, IsHeardNearerByWhoWalkedTowardsIt) {
  const double turn = belt_.bearing(1);
  const double walked = density(before_wall_, turn, 0.4, 0, 0.4);
  EXPECT_GT(walked, 10.0 * density(before_wall_, turn, 0.0, 0, 0.4)) << "who stands expects it where it was";
}

}  // namespace
}  // namespace echoway::tracker
