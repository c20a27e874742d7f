#include "tracker/level_links.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

constexpr double kSlot = 0.0624;

// Three rooms above each other; at one place in the middle one stairs lead up and down.
Building tower() {
  Building b = test::storeys(3);
  b.links.push_back({LevelLinkKind::stairs, 0, {1.0, 1.0}, 1, {2.0, 2.0}});
  b.links.push_back({LevelLinkKind::stairs, 1, {2.0, 2.0}, 2, {3.0, 3.0}});
  return b;
}

// Rooms in which particles that start in room 1 at `at` are found after so many seconds; last, those on the way.
std::array<int, 4> after(double seconds, Vec2 at, const LevelTransition* told, bool led = false) {
  const Building building = tower();
  LevelLinks links(building);
  links.lead(led);
  if (told != nullptr) links.expect(*told);
  Random random(5);
  std::array<int, 4> found{};
  for (int i = 0; i < 400; ++i) {
    Particle p;
    p.room = 1;
    p.position = at;
    p.gait = Gait::walking;
    for (double t = 0.0; t < seconds; t += kSlot) links.step(p, t, kSlot, true, random);
    ++found[p.gait == Gait::away ? 3 : static_cast<std::size_t>(p.room)];
  }
  return found;
}

TEST(LevelLinks, AreNoneInABuildingOfOneLevel) {
  Building b = tower();
  b.links.clear();
  EXPECT_TRUE(LevelLinks(b).none());
}

TEST(LevelLinks, LeaveThoseAloneWhoAreNotNear) { EXPECT_EQ(after(60.0, {6.0, 6.0}, nullptr)[1], 400); }

TEST(LevelLinks, LeadBothWaysForWhoeverWasToldNothing) {
  const auto found = after(40.0, {2.2, 2.0}, nullptr);
  EXPECT_GT(found[0], 15);
  EXPECT_GT(found[2], 15);
}

TEST(LevelLinks, TakeMostWhereTheyWereTold) {
  const LevelTransition up{1, 1, 2, 0.0, 45.0};
  const auto found = after(40.0, {2.2, 2.0}, &up);
  EXPECT_GT(found[2], 4 * found[0]);
}

TEST(LevelLinks, AreTakenByFewWhoAreLedElsewhere) {
  EXPECT_GT(after(40.0, {2.2, 2.0}, nullptr, true)[1], 300);
  const LevelTransition up{1, 1, 2, 0.0, 45.0};
  EXPECT_GT(after(40.0, {2.2, 2.0}, &up, true)[2], 250) << "unless they are told to";
}

TEST(LevelLinks, WhoIsToldOfThemFindsThemFromAFewStepsOff) {
  const LevelTransition up{1, 1, 2, 0.0, 45.0};
  EXPECT_EQ(after(40.0, {3.7, 2.0}, nullptr, true)[1], 400);
  EXPECT_GT(after(40.0, {3.7, 2.0}, &up, true)[2], 250);
}

TEST(LevelLinks, NobodyIsThereAtOnce) {
  const LevelTransition up{1, 1, 2, 0.0, 45.0};
  const auto found = after(4.0, {2.2, 2.0}, &up);
  EXPECT_EQ(found[0] + found[2], 0);
  EXPECT_GT(found[3], 300);
}

/// Somebody on the way up to room 2, or who has come out there walking.
Particle on_the_way() {
  Particle p;
  p.room = 1;
  p.position = {2.0, 2.0};
  p.gait = Gait::away;
  p.link_end = 2;
  return p;
}
Particle come_out() {
  Particle p = on_the_way();
  p.room = 2;
  p.position = {3.0, 3.0};
  p.gait = Gait::walking;
  p.speed = 0.8;
  return p;
}

TEST(LevelLinks, WhoIsLedStandsWhereTheyComeOutUntilTheyAreToldOn) {
  const Building building = tower();
  LevelLinks links(building);
  links.lead(true);
  links.expect({1, 1, 2, 0.0, 45.0});
  const auto gait_after_a_second = [&] {
    Random random(7);
    Particle p = come_out();
    for (double t = 20.0; t < 21.5; t += kSlot) links.step(p, t, kSlot, true, random);
    return p.gait;
  };
  EXPECT_EQ(gait_after_a_second(), Gait::standing);
  links.lead(false);
  EXPECT_EQ(gait_after_a_second(), Gait::walking) << "who finds their own way walks on";
  links.lead(true);
  links.expect({1, 1, 2, 20.0, 0.0});
  EXPECT_EQ(gait_after_a_second(), Gait::walking) << "they are out, and led on";
}

TEST(LevelLinks, WhoMustBeOutStandsAtTheOtherEnd) {
  const Building building = tower();
  LevelLinks links(building);
  links.lead(true);
  links.expect({1, 1, 2, 0.0, 45.0});
  Random random(7);
  Particle p = on_the_way();
  links.land(p, 5.0, true, random);
  EXPECT_NE(p.gait, Gait::away);
  EXPECT_EQ(p.room, 2);
  EXPECT_NEAR(distance(p.position, Vec2{3.0, 3.0}), 0.0, 1e-9);
}

}  // namespace
}  // namespace echoway::tracker
