#pragma once

#include <vector>

#include "echoway/motion/motion_hint.hpp"
#include "wearer/trajectory.hpp"

namespace echoway::sim {

/// What the phone's step detector and gyroscope would have said of a walk, in order of time.
[[nodiscard]] std::vector<MotionHint> sense_motion(const Trajectory& trajectory, const World& world, Random random);

}  // namespace echoway::sim
