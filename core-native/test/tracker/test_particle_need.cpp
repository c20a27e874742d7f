// Few particles are enough while the echoes fit, and the phone's battery lasts longer for it; in doubt there are more.
#include "tracker/particle_need.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

constexpr std::size_t kCapacity = 2000;

TEST(ParticleNeed, IsWhatOnePlaceTakesWhileItFits) {
  EXPECT_EQ(particles_needed({.settled = 60}, kCapacity), 60U);
  EXPECT_EQ(particles_needed({.settled = 60, .cells = 4}, kCapacity), 60U) << "a narrow place is one";
}

TEST(ParticleNeed, GrowsInDoubtByAsMuchForASmallBudgetAsForALargerOne) {
  for (const double doubt : {1.5, 2.0, 4.0}) {
    const std::size_t few = particles_needed({.settled = 5, .doubt = doubt}, kCapacity) - 5;
    const std::size_t more = particles_needed({.settled = 80, .doubt = doubt}, kCapacity) - 80;
    EXPECT_EQ(few, more) << "doubt " << doubt;
    EXPECT_GE(few, 40U) << "doubt " << doubt;
  }
}

TEST(ParticleNeed, GrowsInDoubtInProportionForALargeBudget) {
  EXPECT_EQ(particles_needed({.settled = 300, .doubt = 3.0}, kCapacity), 900U);
}

TEST(ParticleNeed, GrowsWithThePlacesThatArePossible) {
  const std::size_t some = particles_needed({.settled = 60, .cells = 20}, kCapacity);
  EXPECT_GT(some, 60U);
  EXPECT_EQ(particles_needed({.settled = 60, .cells = 40}, kCapacity), 2 * some);
}

TEST(ParticleNeed, IsLargeWhileTheWearerMayBeOnStairs) {
  EXPECT_GE(particles_needed({.settled = 60, .away = true}, kCapacity), 800U);
  EXPECT_EQ(particles_needed({.settled = 60, .away = true, .silent = true}, kCapacity),
            particles_needed({.settled = 60, .away = true}, kCapacity))
      << "an elevator may be silent";
}

TEST(ParticleNeed, IsBoundedInSilenceWhichTellsNothing) {
  EXPECT_EQ(particles_needed({.settled = 60, .silent = true}, kCapacity), 60U);
  const std::size_t silent = particles_needed({.settled = 60, .cells = 100, .silent = true}, kCapacity);
  EXPECT_LE(silent, 400U);
  EXPECT_EQ(particles_needed({.settled = 60, .cells = 140, .doubt = 4.0, .silent = true}, kCapacity), silent);
}

TEST(ParticleNeed, IsNeverMoreThanThereIsRoomFor) {
  for (const bool away : {false, true}) {
    EXPECT_EQ(particles_needed({.settled = 500, .cells = 1000, .doubt = 4.0, .away = away}, 300), 300U);
  }
}

}  // namespace
}  // namespace echoway::tracker
