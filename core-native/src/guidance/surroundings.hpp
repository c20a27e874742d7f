#pragma once

#include "echoway/guidance/cue.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// Direction of `at` from the chest, radians in (-pi, pi].
[[nodiscard]] double direction_to(const Pose2& pose, Vec2 at) noexcept;

/// The door nearest to the wearer in their room, of kind CueKind::door; distance negative when there is none.
[[nodiscard]] Cue nearest_door(const Router& router, const Estimate& estimate);

/// The nearest way out of the wearer's room: a door, an exit, stairs or an elevator. Distance negative: there is none.
[[nodiscard]] Cue nearest_passage(const Router& router, const Estimate& estimate);

/// What the wearer looks at: a place, an exit, stairs or a door within 20 degrees and in sight, else the wall and how
/// far it is.
[[nodiscard]] Cue facing(const Router& router, const Estimate& estimate);

/// What a route leads to, in a cue; nothing for a bare spot.
[[nodiscard]] CueLandmark landmark_of(const Goal& goal) noexcept;

/// "Room 4, Seminar room."
[[nodiscard]] Cue room_cue(CueKind kind, RoomIndex room) noexcept;

}  // namespace echoway::guidance
