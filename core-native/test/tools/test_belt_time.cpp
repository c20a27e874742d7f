// When `echoway monitor` takes a live belt's firings to have arrived.
#include "tools/belt_time.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace echoway::tools {
namespace {

constexpr double kSlot = 0.0624;

/// So many firings, read at once.
std::vector<double> read(BeltTime& time, int firings, double host_s) {
  std::vector<double> arrivals;
  time.on_read(static_cast<std::size_t>(firings), host_s);
  for (int i = 0; i < firings; ++i) {
    arrivals.push_back(time.next());
    time.on_firings(1, 0, host_s);
  }
  return arrivals;
}

/// A belt that is read as it fires, one firing after the other; returns when it fired last.
double follow(BeltTime& time, int firings) {
  double now = 0.0;
  for (int i = 0; i < firings; ++i) {
    now += kSlot;
    EXPECT_EQ(read(time, 1, now).front(), time.tell(now));
    EXPECT_NEAR(time.tell(now), now, 1e-9);
  }
  return now;
}

TEST(BeltTime, IsTheHostsWhileABeltFires) {
  BeltTime time(kSlot);
  const double now = follow(time, 100);
  // Three that USB held back for a moment.
  EXPECT_EQ(read(time, 3, now + 3 * kSlot), std::vector<double>(3, now + 3 * kSlot));
}

TEST(BeltTime, ARecordingThatComesAtOnceTakesAsLongAsItsWalk) {
  BeltTime time(kSlot);
  double last = 0.0;
  for (int piece = 0; piece < 10; ++piece) {
    for (const double arrival : read(time, 100, 0.001 * piece)) {
      EXPECT_NEAR(arrival - last, kSlot, 1e-9);
      last = arrival;
    }
    EXPECT_GE(time.tell(0.001 * piece), last);
  }
}

TEST(BeltTime, WhatWasNotReadForAWhileArrivedMeanwhile) {
  BeltTime time(kSlot);
  const double before = follow(time, 100);
  const double now = before + 10.0;
  const std::vector<double> arrivals = read(time, 160, now);
  EXPECT_NEAR(arrivals.front(), before + kSlot, 1e-9);
  EXPECT_NEAR(arrivals.back(), before + 160 * kSlot, 1e-9);
  EXPECT_NEAR(time.tell(now), now, kSlot);
}

TEST(BeltTime, NeverGoesBackBehindWhatWasTold) {
  BeltTime time(kSlot);
  const double before = follow(time, 100);
  double told = 0.0;
  for (int i = 1; i <= 40; ++i) told = time.tell(before + 0.25 * i);
  for (const double arrival : read(time, 160, before + 10.0)) {
    EXPECT_GE(arrival, told);
    told = arrival;
  }
  EXPECT_GE(time.tell(before + 10.1), told);
}

TEST(BeltTime, CountsWhatTheWireLost) {
  BeltTime time(kSlot);
  const double before = read(time, 100, 0.0).back();
  time.on_read(100, 0.001);
  time.on_firings(1, 9, 0.001);
  EXPECT_NEAR(time.next(), before + 11 * kSlot, 1e-9);
}

}  // namespace
}  // namespace echoway::tools
