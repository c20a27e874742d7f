#include "scene/candidate.hpp"

#include <algorithm>
#include <cmath>

#include "scene/visibility.hpp"

namespace echoway::scene {
namespace {

bool wall_candidate(const Reflector& r, const Box& box, const SightLimits& limits, Candidate& out) noexcept {
  double low = 1e300, high = -1e300, near_side = 1e300, far_side = -1e300;
  for (Vec2 c : box) {
    const double t = r.along(c);
    const double d = r.signed_distance(c);
    low = std::min(low, t);
    high = std::max(high, t);
    near_side = std::min(near_side, d);
    far_side = std::max(far_side, d);
  }
  if (!r.two_sided && far_side <= 0.0) return false;
  if (near_side * far_side < 0.0) near_side = 0.0;
  out.nearest = std::min(std::abs(near_side), std::abs(far_side));
  if (may_be_rough(out, limits)) {
    const double aside = std::sin(limits.rough_cut_off_rad) * limits.rough_range;
    low -= aside;
    high += aside;
  }
  constexpr double kBefore = -kCoarseWallEndSoftness;
  const double beyond = r.length + kCoarseWallEndSoftness;
  if (high < kBefore || low > beyond) return false;
  out.feet = {r.a + std::max(low, kBefore) * r.tangent(), r.a + std::min(high, beyond) * r.tangent()};
  return out.nearest <= limits.max_range;
}

// The stretch of the mirroring wall in which an image can be seen from the box.
bool mirrored_candidate(const RoomScene& room, const Reflector& r, const Box& box, const SightLimits& limits,
                        Candidate& out) noexcept {
  const Reflector& wall = room.reflectors[static_cast<std::size_t>(r.mirror)];
  const double behind = wall.signed_distance(r.a);
  double low = 1e300, high = -1e300;
  for (Vec2 c : box) {
    const double before = wall.signed_distance(c);
    if (before * behind >= 0.0) {
      low = 0.0;           // Part of the box lies behind the wall: any part of the wall may serve.
      high = wall.length;
      break;
    }
    const double t = wall.along(c + before / (before - behind) * (r.a - c));
    low = std::min(low, t);
    high = std::max(high, t);
  }
  if (high < 0.0 || low > wall.length) return false;
  out.feet = {wall.a + std::max(low, 0.0) * wall.tangent(), wall.a + std::min(high, wall.length) * wall.tangent()};
  out.nearest = distance_to_box(r.a, box);
  return out.nearest <= limits.max_mirrored_range;
}

}  // namespace

double distance_to_box(Vec2 p, const Box& box) noexcept {
  const double dx = std::max({box[0].x - p.x, 0.0, p.x - box[2].x});
  const double dy = std::max({box[0].y - p.y, 0.0, p.y - box[2].y});
  return hypotenuse(dx, dy);
}

bool may_answer(const RoomScene& room, std::size_t index, const Box& box, const SightLimits& limits,
                Candidate& out) noexcept {
  const Reflector& r = room.reflectors[index];
  out.reflector = static_cast<std::uint16_t>(index);
  if (r.kind == ReflectorKind::wall) return wall_candidate(r, box, limits, out);
  if (r.kind == ReflectorKind::mirrored_corner) return mirrored_candidate(room, r, box, limits, out);
  out.feet = {r.a, r.b};
  if (r.is_point()) {
    out.nearest = distance_to_box(r.a, box);
    return out.nearest <= (r.kind == ReflectorKind::edge ? limits.max_edge_range : limits.max_range);
  }
  const Vec2 centre = 0.5 * (box[0] + box[2]);
  out.nearest = std::max(0.0, distance(out.feet, centre) - 0.5 * distance(box[0], box[2]));
  return out.nearest <= limits.max_range;
}

}  // namespace echoway::scene
