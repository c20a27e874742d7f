#include "echoway/belt/firing_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "echoway/random.hpp"

namespace echoway {
namespace {

constexpr double kSlot = 0.0624;

TEST(FiringClock, SmoothsBurstsToTheBeltsBeat) {
  // The host hands over what arrived every 200 ms: three or four firings at once.
  FiringClock clock(kSlot);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    const double fired = 10.0 + i * kSlot;
    const double arrival = std::ceil(fired / 0.2) * 0.2;
    const double error = clock.stamp(static_cast<std::uint16_t>(i), arrival).time_s - fired;
    if (i > 100) worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(worst, 0.05);
}

TEST(FiringClock, FollowsABeltThatIsSlowerThanConfigured) {
  FiringClock clock(kSlot);
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double fired = i * 0.08;
    const double arrival = fired + 0.010 * random.uniform();
    const double error = clock.stamp(static_cast<std::uint16_t>(i), arrival).time_s - fired;
    if (i > 400) worst = std::max(worst, std::abs(error));
  }
  EXPECT_LT(worst, 0.05);
}

TEST(FiringClock, CountsWhatTheWireLost) {
  FiringClock clock(kSlot);
  (void)clock.stamp(65534, 0.0);
  const FiringClock::Stamp stamp = clock.stamp(2, 4 * kSlot);  // 65535, 0 and 1 are missing
  EXPECT_EQ(stamp.lost, 3U);
  EXPECT_FALSE(stamp.restarted);
  EXPECT_NEAR(stamp.time_s, 4 * kSlot, 1e-3);
}

TEST(FiringClock, TellsARebootFromALoss) {
  FiringClock clock(kSlot);
  (void)clock.stamp(30000, 0.0);
  const FiringClock::Stamp stamp = clock.stamp(0, 2.0);
  EXPECT_TRUE(stamp.restarted);
  EXPECT_EQ(stamp.lost, 0U);
  EXPECT_DOUBLE_EQ(stamp.time_s, 2.0);
}

TEST(FiringClock, NeverGoesBackEvenWhenTheHostsClockDoes) {
  FiringClock clock(kSlot);
  double last = -1.0;
  const double arrivals[] = {5.0, 5.0, 4.0, 4.1, 100.0, 99.0, 100.1};
  std::uint16_t seq = 0;
  for (const double arrival : arrivals) {
    const double time = clock.stamp(seq++, arrival).time_s;
    EXPECT_GE(time, last);
    last = time;
  }
}

}  // namespace
}  // namespace echoway
