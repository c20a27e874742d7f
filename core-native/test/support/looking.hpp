#pragma once

#include <gtest/gtest.h>

#include "tracker/likelihood.hpp"

/// What somebody at a place expects to hear.
namespace echoway::test {

/// `position` in the room's frame, `heading` in radians.
inline tracker::Particle standing(RoomIndex room, Vec2 position, double heading) {
  tracker::Particle p;
  p.room = room;
  p.position = position;
  p.heading = heading;
  tracker::face_heading(p);
  return p;
}

/// To the last bit.
inline void expect_same(const tracker::ExpectedEchoes& some, const tracker::ExpectedEchoes& all) {
  ASSERT_EQ(some.count, all.count);
  for (int k = 0; k < some.count; ++k) {
    const auto& a = some.echo[static_cast<std::size_t>(k)];
    const auto& b = all.echo[static_cast<std::size_t>(k)];
    ASSERT_EQ(a.range, b.range);
    ASSERT_EQ(a.chance, b.chance);
    ASSERT_EQ(a.extra_variance, b.extra_variance);
    ASSERT_EQ(a.gradient_x, b.gradient_x);
    ASSERT_EQ(a.gradient_y, b.gradient_y);
  }
}

}  // namespace echoway::test
