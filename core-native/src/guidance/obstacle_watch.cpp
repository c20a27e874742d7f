#include "guidance/obstacle_watch.hpp"

#include <algorithm>
#include <cmath>

#include "guidance/echo_preview.hpp"
#include "guidance/place_change.hpp"

namespace echoway::guidance {
namespace {

constexpr double kSector = degrees(36.0);  ///< Things further off the chest are not told to a walker.
constexpr double kFurthest = 3.5;          ///< Echoes are followed from here, metres.
constexpr double kBesides = 1.2;           ///< The same beside and behind the wearer.
constexpr double kNearest = 0.25;          ///< Nearer ones are the wearer's own hands.
constexpr double kMargin = 0.35;           ///< Metres nearer than anything mapped, besides the position's error.
constexpr double kSame = 0.5;              ///< Hits this close together are one thing, metres.
constexpr double kMemory = 4.0;            ///< Seconds.
constexpr double kCorridor = 0.45;         ///< Things further to the side than this are passed by, metres.

}  // namespace

void ObstacleWatch::on_firing(const Firing& firing, const Estimate& e) noexcept {
  const BeltConfig& belt = config_->belt;
  if (firing.sensor < 0 || firing.sensor >= belt.sensors) return;
  if (!firing.has_echo() || !std::isfinite(firing.range_m)) return;
  const double bearing = wrap_angle(belt.bearing(firing.sensor));
  const double furthest = std::abs(bearing) > kSector ? kBesides : kFurthest;
  if (firing.range_m < kNearest || firing.range_m > furthest) return;
  if (!is_place(router_->building(), e)) return;
  const FreeSpace& space = router_->space(e.room);
  const double axis = e.pose.heading + bearing;
  const Vec2 face = e.pose.position + belt.radius_m * unit_from_angle(axis);
  const double blur = std::isfinite(e.sigma_heading_rad) ? std::min(e.sigma_heading_rad, degrees(20.0)) : degrees(20.0);
  const double half = 0.5 * belt.beam_rad + degrees(4.0) + 2.0 * blur;
  const double mapped = nearest_in_cone(space, face, axis, half, kFurthest + 2.0);
  if (firing.range_m > mapped - kMargin - 2.0 * e.sigma_m) return;
  const Vec2 at = face + firing.range_m * unit_from_angle(axis);
  if (!space.contains(at)) return;  // seen through a door: another room's wall
  hits_[count_++ % kHits] = {firing.time_s, e.room, at};
}

bool ObstacleWatch::is_steady(const Hit& hit, const Estimate& e) const noexcept {
  const auto recent = [&](const Hit& h) { return h.room == e.room && e.time_s - h.time_s <= kMemory; };
  if (!recent(hit)) return false;
  int agree = 0;
  for (std::size_t i = 0; i < std::min(count_, kHits); ++i) {
    agree += recent(hits_[i]) && distance(hits_[i].at, hit.at) <= kSame ? 1 : 0;
  }
  return agree >= config_->obstacle_firings;
}

ObstacleWatch::Sighting ObstacleWatch::nearest(const Estimate& e, double reach) const noexcept {
  Sighting best;
  steady(e, [&](Vec2 at) {
    const Vec2 local = e.pose.inverse_transform(at);
    const double away = std::max(0.0, norm(local) - config_->belt.radius_m);
    const double direction = std::atan2(local.y, local.x);
    if (std::abs(direction) > kSector || std::abs(local.y) > kCorridor || away > reach) return;
    if (!best.present || away < best.distance_m) best = {true, away, direction};
  });
  return best;
}

}  // namespace echoway::guidance
