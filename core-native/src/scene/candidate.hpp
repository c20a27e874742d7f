#pragma once

#include <array>
#include <cstdint>

#include "scene/room_scene.hpp"

namespace echoway::scene {

/// How far sensors see, for leaving out what cannot answer.
struct SightLimits {
  double max_range = 0.0;               ///< From the transducer's face, metres.
  double max_edge_range = 0.0;          ///< Beyond it no edge answers.
  double max_mirrored_range = 0.0;      ///< Beyond it nothing is heard by way of a wall.
  double all_reflective_cut_off_rad = 0.0;   ///< All-reflective elements answer within the beam itself, others ...
  double sharp_cut_off_rad = 0.0;       ///< up to this angle off its axis, ...
  double cut_off_rad = 0.0;             ///< up to this one where headings are on a coarse grid ...
  double rough_range = 0.0;             ///< ... but walls nearer than this, which may be rough:
  double rough_cut_off_rad = 0.0;       ///< they are silent beyond this angle.
};

/// An upright box of places, from its lower left corner counter-clockwise.
using Box = std::array<Vec2, 4>;

[[nodiscard]] inline Box make_box(Vec2 low, Vec2 high) noexcept {
  return {low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}};
}
[[nodiscard]] double distance_to_box(Vec2 p, const Box& box) noexcept;

/// A reflector, and the stretch of it from which an echo can come back into a box.
struct Candidate {
  std::uint16_t reflector = 0;
  double nearest = 0.0;                 ///< Lower bound of its distance from the box.
  Segment feet{};                       ///< Of a mirrored corner: where the wall may be met.
};

/// False only when nothing of the room's reflector `index` can answer anybody in `box`, whatever stands in between.
[[nodiscard]] bool may_answer(const RoomScene& room, std::size_t index, const Box& box, const SightLimits& limits,
                              Candidate& out) noexcept;

[[nodiscard]] inline bool may_be_rough(const Candidate& wall, const SightLimits& limits) noexcept {
  return wall.nearest < limits.rough_range;
}

}  // namespace echoway::scene
