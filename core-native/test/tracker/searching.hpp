#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "tracker/refinement.hpp"

namespace echoway::tracker {

/// A building, what a belt has heard in it so far, and all that a search knows besides its domain.
class SearchingTest : public ::testing::Test {
 protected:
  explicit SearchingTest(Building building) : building_(std::move(building)) {}

  /// Nothing heard yet, by a wearer who does not turn.
  [[nodiscard]] Record record_of(int sensor) const {
    Record record;
    record.interval.seconds = belt_.slot_s;
    record.interval.turn_known = true;
    record.sensor = sensor;
    return record;
  }

  [[nodiscard]] SearchTools tools() {
    return {model_, scene_, motion_, belt_, history_, building_, 0.0, 0.004, 0.0, 0.5};
  }

  Building building_;
  BeltConfig belt_;
  EchoModel model_{belt_, EchoModelParameters{}};
  scene::Scene scene_{building_, model_.sight_limits()};
  MotionParameters motion_;
  History history_;
  Random random_{1};
};

}  // namespace echoway::tracker
