#pragma once

#include <span>

#include "support/blind_walk.hpp"
#include "tracked_pose.hpp"

namespace echoway::proof {

/// What a walk was to be: its way and what stands about it.
void print_scene(const Building& b, const Route& way, test::PoseSource& poses);

/// Once a second and at each line: where the wearer was, where the tracker took them to be, and what they heard.
void print_diary(const Building& b, std::span<const TrackedPose::Entry> diary, const test::WalkOutcome& o);

}  // namespace echoway::proof
