#pragma once

#include "scene/candidate.hpp"

namespace echoway::scene {

/// Takes out of `room` what lies beyond its doors and nobody in the room, or half a metre around its floor, can hear,
/// and whatever blocks the sight of nothing else. What is left gives the same echoes; it keeps its order.
void leave_out_inaudible(RoomScene& room, const SightLimits& limits);

}  // namespace echoway::scene
