#include "tracker/history.hpp"

#include <gtest/gtest.h>

namespace echoway::tracker {
namespace {

// Firings of which the belief and a second one make what their number says.
void fill(History& history, int firings) {
  for (int n = 0; n < firings; ++n) {
    Record record;
    record.log_main = -n;
    record.log_second = -1000.0 - n;
    history.push(record);
  }
}

// A search asks what the belief has made of the echoes: it is not to beat what another one made of them.
TEST(History, TellsWhatTheBeliefOfNowMadeOfTheEchoes) {
  static History history;
  fill(history, 40);
  history.exchange(30);
  EXPECT_EQ(history[29].log_main, -29.0);
  EXPECT_EQ(history[30].log_main, -1030.0);
  EXPECT_EQ(history[39].log_main, -1039.0);
  EXPECT_EQ(history[39].log_second, -39.0);
}

TEST(History, OfABeliefThatIsOlderThanWhatItKeepsIsAllThatOnes) {
  static History history;
  constexpr int kMany = 3 * static_cast<int>(History::kSize) / 2;
  fill(history, kMany);
  history.exchange(1);
  EXPECT_EQ(history[history.begin()].log_main, -1000.0 - static_cast<double>(history.begin()));
  EXPECT_EQ(history[kMany - 1].log_main, -1000.0 - (kMany - 1));
}

}  // namespace
}  // namespace echoway::tracker
