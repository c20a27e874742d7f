#pragma once

#include <cstdint>

#include "echoway/building/building.hpp"
#include "echoway/sim/simulate.hpp"

namespace echoway::rays {

/// The same way through the building, heard in a world of rays (World) instead of the simulator's, and felt by another
/// phone: steps of one length, of which one in twenty is missed, which come up to 0.3 s late; a gyroscope of 48 Hz that
/// is off by up to 1 degree a second; once a second a compass that drifts. REQUIRES: the building has one level, and
/// the walk a row of truth for each firing.
[[nodiscard]] sim::Simulation heard_by_rays(const Building& building, const sim::Simulation& walk, std::uint64_t seed);

}  // namespace echoway::rays
