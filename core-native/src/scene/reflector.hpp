#pragma once

#include <cstddef>
#include <cstdint>

#include "echoway/geometry/segment.hpp"
#include "echoway/geometry/vec2.hpp"

namespace echoway::scene {

enum class ReflectorKind : std::uint8_t {
  wall,
  corner,
  edge,
  all_reflective,
  mirrored_corner,  ///< A corner heard by way of a wall that is not met squarely: the corner's image behind that wall.
};
inline constexpr std::size_t kReflectorKinds = 5;

/// Something that can answer a firing, in the frame of the room from which it is seen.
struct Reflector {
  ReflectorKind kind = ReflectorKind::wall;
  bool two_sided : 1 = false;    ///< A screen: answers from both sides.
  bool seen_from_left : 1 = true;   ///< Its normal points to the left of a -> b, else to the right.
  std::int16_t opening = -1;     ///< Index of the room's opening through which it is seen; -1: the room's own.
  std::int16_t own_index = -1;   ///< Index among the room's occluders of the piece itself, which cannot hide itself.
  std::int16_t mirror = -1;      ///< Of a mirrored corner: index among the room's reflectors of the mirroring wall.
  Vec2 a{};                      ///< Ends; a == b for corners and edges. Of a mirrored corner its image
  Vec2 b{};                      ///< and the corner itself.
  Vec2 normal{};                 ///< Unit, towards the side from which it is seen. Zero for points.
  double offset = 0.0;           ///< normal . p + offset: distance of p from the line, positive on the visible side.
  double length = 0.0;

  [[nodiscard]] bool is_point() const noexcept {
    return kind != ReflectorKind::wall && kind != ReflectorKind::all_reflective;
  }
  [[nodiscard]] double signed_distance(Vec2 p) const noexcept { return dot(normal, p) + offset; }
  /// Unit, from a to b. Zero for points.
  [[nodiscard]] Vec2 tangent() const noexcept {
    return seen_from_left ? Vec2{normal.y, -normal.x} : Vec2{-normal.y, normal.x};
  }
  [[nodiscard]] double along(Vec2 p) const noexcept { return dot(tangent(), p - a); }
};

/// A wall or all-reflective element from `s`, seen from the left of a -> b or from the right. REQUIRES: s has a length.
[[nodiscard]] Reflector make_segment_reflector(ReflectorKind kind, const Segment& s, bool seen_from_left) noexcept;
[[nodiscard]] Reflector make_point_reflector(ReflectorKind kind, Vec2 at) noexcept;

/// `r` as seen from another frame, into which a rotation by (cos, sin) and then a shift takes it.
[[nodiscard]] Reflector transformed(const Reflector& r, Vec2 rotation, Vec2 shift) noexcept;

}  // namespace echoway::scene
