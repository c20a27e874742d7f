#include "guidance/turn_watch.hpp"

#include <gtest/gtest.h>

namespace echoway::guidance {
namespace {

TEST(TurnWatch, SeesATurnSoonWheneverItBegins) {
  constexpr double kSlot = 0.0625;
  constexpr double kRate = degrees(90.0);  // a second
  for (double begins = 5.0; begins < 6.0; begins += kSlot) {
    TurnWatch watch;
    double seen = 1e9;
    for (double now = 0.0; now < 7.0 && seen > 1e8; now += kSlot) {
      watch.update(now < begins ? 0.0 : kRate * (now - begins), now);
      if (watch.turning()) seen = now;
    }
    EXPECT_GT(seen, begins);
    EXPECT_LT(seen, begins + 0.4) << begins;
  }
}

}  // namespace
}  // namespace echoway::guidance
