// `echoway play` waits at its end until the listener has read all of it.
#include "tools/await_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace echoway::tools {
namespace {

using namespace std::chrono_literals;

/// Passes when it is slept, and only then.
class FakeTime {
 public:
  [[nodiscard]] std::chrono::steady_clock::time_point now() const { return now_; }
  void sleep(std::chrono::milliseconds time) { now_ += time; }
  [[nodiscard]] std::chrono::steady_clock::duration passed() const { return now_.time_since_epoch(); }

 private:
  std::chrono::steady_clock::time_point now_{};
};

/// What waits on the line after so much time.
using Line = std::function<int(std::chrono::steady_clock::duration)>;

struct Waited {
  bool all_read = false;
  std::chrono::steady_clock::duration time{};
};
Waited wait(const Line& line, std::chrono::milliseconds patience) {
  FakeTime time;
  const bool all_read = await_reading([&] { return line(time.passed()); }, time, patience);
  return {all_read, time.passed()};
}

TEST(AwaitReading, WaitsAsLongAsItIsToldForAListenerWhoHasNotBegun) {
  const Line read_after_an_hour = [](auto passed) { return passed < 1h ? 4000 : 0; };
  const Waited waited = wait(read_after_an_hour, 24h);
  EXPECT_TRUE(waited.all_read);
  EXPECT_GE(waited.time, 1h);
}

TEST(AwaitReading, GivesUpWhenNothingIsReadForSoLong) {
  const Waited waited = wait([](auto) { return 4000; }, 30s);
  EXPECT_FALSE(waited.all_read);
  EXPECT_EQ(waited.time, 30s);
}

TEST(AwaitReading, WhoReadsLittleByLittleReads) {
  const Line byte_by_byte = [](auto passed) { return static_cast<int>(100 - std::min<long>(100, passed / 1500ms)); };
  EXPECT_TRUE(wait(byte_by_byte, 2s).all_read);
}

// Between what was read and what follows it on the line, nothing waits for a moment.
TEST(AwaitReading, WhatTheLineBringsLaterIsWaitedForToo) {
  const Line in_two_pieces = [](auto passed) { return passed == 1s ? 0 : passed < 10s ? 2000 : 0; };
  const Waited waited = wait(in_two_pieces, 30s);
  EXPECT_TRUE(waited.all_read);
  EXPECT_GE(waited.time, 10s);
}

}  // namespace
}  // namespace echoway::tools
