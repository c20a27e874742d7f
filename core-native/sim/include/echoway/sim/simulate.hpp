#pragma once

#include <cstdint>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/io/logs.hpp"
#include "echoway/motion/motion_hint.hpp"
#include "echoway/result.hpp"
#include "echoway/sim/walk.hpp"

namespace echoway::sim {

/// What a simulated walk leaves behind.
struct Simulation {
  ScanLog scans;
  std::vector<MotionHint> motion;
  std::vector<TruthRow> truth;  ///< One row per firing: the wearer's axis and chest when the sensor fired.
};

/// Sends a wearer through `building` as `walk` says. The same building, walk and seed give the same bytes.
/// Fails when the walk names a room that does not exist, a place outside its room, or one that cannot be reached.
Result<Simulation> simulate(const Building& building, const Walk& walk, std::uint64_t seed);

/// The same with the walk's own seed.
Result<Simulation> simulate(const Building& building, const Walk& walk);

}  // namespace echoway::sim
