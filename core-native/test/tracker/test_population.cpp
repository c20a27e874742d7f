#include "tracker/population.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace echoway::tracker
