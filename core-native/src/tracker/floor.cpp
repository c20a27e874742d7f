#include "tracker/floor.hpp"

#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

using scene::FloorLoops;
using scene::Opening;
using scene::RoomScene;

constexpr double kDoorwaySlack = 0.25;   // Beside the opening, where a slightly wrong mean still means the doorway.
constexpr double kStride = 1.2;          // Beyond the door's plane, as far as one interval may carry a mean.
constexpr double kBody = 0.20;           // Nobody's axis comes nearer to a wall, metres.
constexpr double kLeastClearance = 0.12; // The least for a place told or tried: it is wrong by some centimetres.
constexpr double kWallSlack = 0.10;      // Maps and means are this wrong near walls.

void enter(Particle& p, const Opening& o) noexcept {
  p.position = o.to_neighbour(p.position);
  p.room = o.to;
  if (o.rotation.x != 1.0) turn(p, o.rotation);
}

// Whether a doorway is why the mean lies off the room's floor, or so near to its wall (`to_wall` metres). Beyond the
// middle of that wall the particle is in the next room from now on.
bool is_in_doorway(Particle& p, scene::Scene& scene, const RoomScene& room, bool inside, double to_wall) noexcept {
  bool within = false;
  for (const Opening& o : room.openings) {
    const Vec2 off = p.position - o.centre;
    if (std::abs(dot(off, o.tangent)) > o.half_width + kDoorwaySlack) continue;
    const double across = std::abs(cross(off, o.tangent));
    if (across > kStride + o.gap) continue;
    if (inside) return true;
    const Vec2 there = o.to_neighbour(p.position);
    const FloorLoops& next = scene.room(o.to).floor;
    const bool within_wall = across <= o.gap + kWallSlack;
    if (next.contains(there) || (within_wall && next.distance(there) < to_wall)) {
      enter(p, o);
      return true;
    }
    within = within || within_wall;
  }
  return within;
}

}  // namespace

bool can_stand(const RoomScene& room, Vec2 position) noexcept {
  return is_finite(position) && room.floor.contains(position) && room.floor.distance(position) > kLeastClearance;
}

double settle_on_floor(Particle& p, scene::Scene& scene) noexcept {
  if (scene.cell_at(p.room, p.position).plain_floor) {
    const RoomScene& room = scene.room(p.room);
    const Vec2 q = p.position;
    if (q.x >= room.low.x && q.y >= room.low.y && q.x <= room.high.x && q.y <= room.high.y) return 1.0;
  }
  const RoomScene& room = scene.room(p.room);
  const bool inside = room.floor.contains(p.position);
  const double to_wall = room.floor.distance(p.position);
  if (inside && to_wall >= kBody) return 1.0;
  if (is_in_doorway(p, scene, room, inside, to_wall)) return 1.0;
  const double variance = kWallSlack * kWallSlack + 0.5 * (p.cov.xx + p.cov.yy);
  const double outside = inside ? kBody - to_wall : kBody + to_wall;
  return fast_exp(-0.5 * outside * outside / variance);
}

}  // namespace echoway::tracker
