#pragma once

#include <vector>

#include "acoustics/echo_paths.hpp"
#include "wearer/trajectory.hpp"

namespace echoway::sim {

/// The wearer's arms where they swing beside the belt, in the frame of the wearer's view. `share` of the time they do;
/// else the hands are up (a phone, a cane) and out of the beams.
void add_arms(const Moment& moment, double share, std::vector<Obstacle>& obstacles);

}  // namespace echoway::sim
