#include "guidance/doorway.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::guidance {
namespace {

/// Nearer to a door's wall than this, a doorway can be entered only from at most so far off its axis, metres.
constexpr double kNearWall = 0.7;
constexpr double kAside = 0.2;
/// Who goes through aslant heads for a spot so far beyond, metres.
constexpr double kBeyond = 0.35;

}  // namespace

std::optional<Doorway> Doorway::of(const Router& router, RoomIndex room, std::int32_t door, double body_m) noexcept {
  for (const Passage& p : router.space(room).passages()) {
    if (p.door != door || p.inward == Vec2{}) continue;
    return Doorway(p, router.building().doors[static_cast<std::size_t>(door)].width, body_m);
  }
  return std::nullopt;
}

double Doorway::crossing(Vec2 from, Vec2 ahead) const noexcept {
  return beside(from + (before(from) / -dot(ahead, passage_.inward)) * ahead);
}

bool Doorway::lets_through(Vec2 from, Vec2 to, bool begun) const noexcept {
  constexpr double kSlant = 0.7;  // cosine of 45 degrees
  const double near = before(from);
  const double behind = before(to);
  if (behind > 0.0 || near - behind < kSlant * distance(to, from)) return false;
  // Beside the opening and close to its wall: back to where it can be entered squarely.
  if (near < kNearWall && aside(from) > (begun ? kAside + 0.1 : kAside)) return false;
  const Vec2 crossing = from + (std::max(near, 0.0) / (near - behind)) * (to - from);
  const double play = std::max(0.5 * width_ - body_m_, 0.5 * kDoorMiss);
  return distance(crossing, passage_.centre) <= (begun ? play : 0.6 * play);
}

std::optional<Vec2> Doorway::slant(const Pose2& pose, double sigma_m, bool begun) const noexcept {
  const Vec2 from = pose.position - passage_.centre;
  const double near = before(pose.position);
  const double away = norm(from);
  // Given up later than it is taken up.
  const double slack = begun ? 1.25 : 1.0;
  const bool close = near * slack >= 0.12 && near <= kNearWall * slack && aside(pose.position) <= 0.5 * width_ * slack;
  if (!close || width_ * near * slack < 2.0 * body_m_ * away) return std::nullopt;
  // So close, a small error of position is a large one of direction: whoever faces the opening anyhow may walk on.
  const Vec2 ahead = unit_from_angle(pose.heading);
  const double slope = -dot(ahead, passage_.inward);
  constexpr double kNotTooSlant = 0.6;  // cosine
  if (slope > kNotTooSlant) {
    const double on = near / slope;
    const double beside = aside(pose.position + on * ahead);
    if (beside + 0.2 + std::min(sigma_m, 0.2) < 0.5 * width_ * slack) return pose.position + (on + kBeyond) * ahead;
  }
  return passage_.centre - (kBeyond / away) * from;
}

}  // namespace echoway::guidance
