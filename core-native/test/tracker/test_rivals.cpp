#include "tracker/rivals.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

// Puts one in the place that is due, and lets it gain so many nats over the belief.
Rival& add(Rivals& rivals, double gain) {
  Rival& rival = rivals.place_for_another();
  rival.population().clear();
  Particle p;
  p.weight = 1.0;
  rival.population().push(p);
  rival.begin(-20.0);
  EXPECT_EQ(rival.judge({0.0, gain, 1.0}, Rival::Belief::proved), Rival::Verdict::undecided);
  return rival;
}

TEST(Rivals, AreNoneUntilOneIsAdded) {
  Rivals rivals(2, 4);
  EXPECT_TRUE(rivals.none());
  add(rivals, 1.0);
  EXPECT_FALSE(rivals.none());
  rivals.dismiss_all();
  EXPECT_TRUE(rivals.none());
}

TEST(Rivals, StandSideBySideWhileThereIsRoom) {
  Rivals rivals(2, 4);
  const Rival& first = add(rivals, 1.0);
  const Rival& second = add(rivals, 1.0);
  EXPECT_NE(&first, &second);
  EXPECT_TRUE(first.present() && second.present());
}

TEST(Rivals, OneMoreTakesThePlaceOfWhoHasGainedLeast) {
  Rivals rivals(2, 4);
  const Rival& good = add(rivals, 4.0);
  const Rival& idle = add(rivals, -2.0);
  EXPECT_EQ(&rivals.place_for_another(), &idle);
  EXPECT_TRUE(good.present());
}

TEST(Rivals, OnlyTheOneThatIsKeptStays) {
  Rivals rivals(2, 4);
  const Rival& kept = add(rivals, 1.0);
  const Rival& other = add(rivals, 1.0);
  rivals.dismiss_others(kept);
  EXPECT_TRUE(kept.present());
  EXPECT_FALSE(other.present());
}

}  // namespace
}  // namespace echoway::tracker
