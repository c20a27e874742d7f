#pragma once

#include "following.hpp"

namespace echoway::report {

/// A random walk in a building for ablations and robustness: the lab for even numbers, a random office for odd ones.
struct Roam {
  Building world;
  sim::Walk walk;
};
[[nodiscard]] Roam roam(int number, double seconds, double speed_mps);

/// One row of figures: group,level,number,method and Summary, processor time last.
inline constexpr std::string_view kRoamColumns =
    "group,level,walk,method,mean_m,median_m,p90_m,turn_deg,right_room,within_2_sigma,cpu_us";

}  // namespace echoway::report
