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
/// Fails when the walk names a room that does not exist, a place outside its room, or one that cannot be reached, and
/// when a room is more than half a kilometre large.
Result<Simulation> simulate(const Building& building, const Walk& walk, std::uint64_t seed);

/// The same with the walk's own seed.
Result<Simulation> simulate(const Building& building, const Walk& walk);

/// A ring of sensors that need not be evenly spaced.
struct Ring {
  BeltConfig belt{};                 ///< Radius, least and greatest range; its slot is not waited for.
  std::vector<double> bearings_rad;  ///< From the chest; empty: evenly spaced as belt.sensors says.
};

/// One whole scan, in no time, at each of `stands`: what a wearer (or a robot) who stands there hears. Rows come stand
/// by stand, sensor by sensor, with the stand's time. Fails, with the stand's line, when it names a room that does
/// not exist or lies more than kBesideRoom outside its room, or as simulate() does.
Result<ScanLog> scan_at(const Building& building, const World& world, const Ring& ring,
                        const std::vector<TruthRow>& stands, std::uint64_t seed);

}  // namespace echoway::sim
