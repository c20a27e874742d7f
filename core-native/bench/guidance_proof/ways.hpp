#pragma once

#include <optional>

#include "echoway/routing/router.hpp"
#include "tracked_pose.hpp"

namespace echoway::proof {

/// A way of which only the ends are kept free: two stretches of no length, with stairs to each, which lie nowhere.
[[nodiscard]] Route ends_of(const Route& way);

/// The shortest way for who knows where everything stands; none when there is no room to pass.
[[nodiscard]] std::optional<double> shortest_round_things(const Building& plan, TrackedPose& world, const Spot& start,
                                                          const Spot& end);

}  // namespace echoway::proof
