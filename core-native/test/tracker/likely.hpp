#pragma once

#include <algorithm>
#include <span>

#include "echoway/locate/estimate.hpp"

namespace echoway::test {

/// Whether one of the likely places is about `place`, in its room.
inline bool is_likely(std::span<const Hypothesis> places, Vec2 place) {
  return std::ranges::any_of(places, [&](const Hypothesis& h) {
    return h.probability > 0.1 && distance(h.pose.position, place) < 0.5;
  });
}

}  // namespace echoway::test
