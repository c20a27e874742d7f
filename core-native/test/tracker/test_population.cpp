#include "tracker/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tracker/rows.hpp"

namespace echoway::tracker {
namespace {

using test::mean_of;
using test::row_of;

TEST(Population, ExchangedForAnotherIsWhatThatWas) {
  Random random(1);
  Population tracked = row_of(30, 400), other = row_of(300, 300);
  const double of_few = mean_of(tracked.particles()), of_many = mean_of(other.particles());
  tracked.exchange(other, random);
  EXPECT_EQ(tracked.size(), 300u);
  EXPECT_EQ(other.size(), 30u);
  EXPECT_DOUBLE_EQ(mean_of(tracked.particles()), of_many);
  EXPECT_DOUBLE_EQ(mean_of(other.particles()), of_few);
}

// What a doubt finds elsewhere is added to the belief: it needs the room, whichever place is believed in.
TEST(Population, ThatIsExchangedForASmallerOneStillHasRoomForAsMany) {
  Random random(1);
  Population tracked = row_of(30, 400), other = row_of(20, 20);
  tracked.exchange(other, random);
  EXPECT_EQ(tracked.capacity(), 400u);
  EXPECT_EQ(other.capacity(), 20u);
  for (int i = 0; i < 300; ++i) tracked.push({});
  EXPECT_EQ(tracked.size(), 320u);
}

TEST(Population, ThatTheOtherHasNoRoomForIsDrawnFrom) {
  Random random(1);
  Population tracked = row_of(400, 400), other = row_of(20, 40);
  const double of_all = mean_of(tracked.particles());
  tracked.exchange(other, random);
  EXPECT_EQ(tracked.size(), 20u);
  EXPECT_EQ(other.size(), 40u);
  EXPECT_NEAR(mean_of(other.particles()), of_all, 5.0);
}

TEST(Population, KeepsItsPlacesApartWhenItIsExchanged) {
  Random random(1);
  Population tracked = test::row_in_two_places(40, random), other = row_of(20, 40);
  tracked.exchange(other, random);
  EXPECT_EQ(other.main_size(), 30u);
  EXPECT_EQ(tracked.main_size(), 20u);
}

// A likely half of a belief and an unlikely one, at one place.
class UnlikelyHalf : public ::testing::Test {
 protected:
  static constexpr std::size_t kCount = 80;
  static constexpr double kUnlikely = 0.02;

  static Population drawn(std::uint64_t seed) {
    Random random(seed);
    Population belief(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      Particle p;
      p.position.x = i < kCount / 2 ? 0.0 : 1.0;
      p.weight = (i < kCount / 2 ? 1.0 - kUnlikely : kUnlikely) * 2.0 / kCount;
      belief.push(p);
    }
    const std::array<std::uint8_t, kCount> one_mode{};
    belief.resample(one_mode, std::array<std::size_t, 1>{kCount}, random);
    return belief;
  }
};

TEST_F(UnlikelyHalf, KeepsMoreOfTheParticlesThanOfTheWeight) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Population belief = drawn(seed);
    const auto kept = std::ranges::count_if(belief.particles(), [](const Particle& p) { return p.position.x > 0.5; });
    EXPECT_GE(kept, 4) << "its share is one or two";
  }
}

TEST_F(UnlikelyHalf, IsAsLikelyAsBefore) {
  double sum = 0.0;
  constexpr int kSeeds = 200;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Population belief = drawn(seed);
    for (const Particle& p : belief.particles()) sum += p.weight * p.position.x;
  }
  EXPECT_NEAR(sum / kSeeds, kUnlikely, 0.1 * kUnlikely);
}

}  // namespace
}  // namespace echoway::tracker
