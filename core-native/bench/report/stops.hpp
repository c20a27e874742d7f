#pragma once

#include <cstdint>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/sim/simulate.hpp"
#include "thesis/scan.hpp"

namespace echoway::report {

/// sim::simulate() that throws std::runtime_error.
[[nodiscard]] sim::Simulation walk_through(const Building& world, const sim::Walk& walk);
/// A walk file of a building of maps/, by its name.
[[nodiscard]] sim::Walk read_plan_walk(std::string_view plan, std::string_view name);

/// How long to stand for two passes, settling included, seconds.
[[nodiscard]] double pause_for(const BeltConfig& belt) noexcept;

/// The thesis's wearer stands still while the belt scans: the same way in steps of `step_m` (and of 20 degrees where
/// the wearer turns on the spot), with a pause of two passes after each. Lights, doors and faults happen where they
/// did.
[[nodiscard]] sim::Walk with_stops(const Building& world, const sim::Walk& walk, double step_m);

/// The first two passes of a pause.
struct Stop {
  std::size_t first = 0;  ///< Index of its first firing.
  RoomIndex room = kNoRoom;
  Pose2 pose{};
};
[[nodiscard]] std::vector<Stop> find_stops(const Building& world, const sim::Simulation& walk);
/// The firings of all stops.
[[nodiscard]] std::vector<Firing> firings_at(const std::vector<Stop>& stops, const sim::Simulation& walk);
/// One stop's firings as the thesis makes a scan of them.
[[nodiscard]] thesis::Scan scan_at(const Stop& stop, const sim::Simulation& walk, const ThesisParameters& parameters);

}  // namespace echoway::report
