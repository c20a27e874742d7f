#pragma once

#include <span>
#include <vector>

#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// A vertex of the way ahead, in one frame.
struct LinePoint {
  Vec2 at{};
  WaypointKind kind = WaypointKind::turn;
  std::int32_t index = -1;  ///< Door or link.
};

/// Lays a route out in the frame of its first room: rooms are unfolded door by door, up to the goal or the first
/// stairs. `line` is reused.
void lay_out(const Route& route, const Building& building, std::vector<LinePoint>& line);

/// The next turn on a way, several close ones of one sense taken together.
struct Manoeuvre {
  bool present = false;
  double distance = 0.0;   ///< Along the way, to where it is made.
  double heading = 0.0;    ///< Direction of the way after it, in the line's frame.
  double run_out = 0.0;    ///< Length of the straight after it.
  std::size_t first = 0;   ///< Vertices of `line` that it takes together.
  std::size_t last = 0;
};

/// The first turn by more than `least` on the way from line[0].
[[nodiscard]] Manoeuvre next_manoeuvre(std::span<const LinePoint> line, double least, double fuse) noexcept;

[[nodiscard]] double length_of(std::span<const LinePoint> line) noexcept;

/// The point `along` metres down the line, its end beyond. REQUIRES: line is not empty.
[[nodiscard]] Vec2 point_along(std::span<const LinePoint> line, double along) noexcept;

}  // namespace echoway::guidance
