#pragma once

#include "support/blind_walk.hpp"
#include "tracked_pose.hpp"

namespace echoway::proof {

/// Lines that tell the wearer which way to move, or that they are there; not what a lost one is asked to do to be
/// found.
[[nodiscard]] bool leads(const Cue& cue);

/// How many lines led the wearer while the tracker took them to be elsewhere: they may send anybody anywhere.
[[nodiscard]] int told_from_wrong_place(const Building& b, const TrackedPose& tracked, const test::WalkOutcome& o);

}  // namespace echoway::proof
