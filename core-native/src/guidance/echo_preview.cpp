#include "guidance/echo_preview.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway::guidance {
namespace {

bool within(Vec2 tip, double axis, double half_angle, Vec2 p) {
  const Vec2 d = p - tip;
  return std::abs(wrap_angle(std::atan2(d.y, d.x) - axis)) <= half_angle;
}

/// Distance from `tip` to `p` if it lies in the cone, else `limit`.
double if_within(Vec2 tip, double axis, double half_angle, Vec2 p, double limit) {
  return within(tip, axis, half_angle, p) ? distance(tip, p) : limit;
}

}  // namespace

double nearest_in_cone(const FreeSpace& space, Vec2 tip, double axis, double half_angle, double limit) noexcept {
  double best = limit;
  const Vec2 left = unit_from_angle(axis + half_angle);
  const Vec2 right = unit_from_angle(axis - half_angle);
  for (const Segment& s : space.solids()) {
    if (distance(s, tip) >= best) continue;
    // The nearest point of a segment within a wedge is its nearest point, an end, or where a side of the wedge cuts it.
    best = std::min({best, if_within(tip, axis, half_angle, nearest_point(s, tip), limit),
                     if_within(tip, axis, half_angle, s.a, limit), if_within(tip, axis, half_angle, s.b, limit),
                     ray_distance(tip, left, s), ray_distance(tip, right, s)});
  }
  return best;
}

double preview_range(const Room& room, const FreeSpace& space, Vec2 face, double axis, double half_beam,
                     double limit) noexcept {
  double best = limit;
  for (const Segment& s : space.solids()) {
    const double t = nearest_parameter(s, face);
    if (t <= 0.0 || t >= 1.0) continue;  // no perpendicular foot
    best = std::min(best, if_within(face, axis, half_beam, nearest_point(s, face), limit));
  }
  for (const Segment& s : room.reflectors) {
    best = std::min(best, if_within(face, axis, half_beam, nearest_point(s, face), limit));
  }
  for (const Vec2 corner : room.corners) best = std::min(best, if_within(face, axis, half_beam, corner, limit));
  return best;
}

}  // namespace echoway::guidance
