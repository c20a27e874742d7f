#include "echoway/routing/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "routing/doorways.hpp"

namespace echoway {
namespace {

/// Slack that keeps a way exactly at the wanted clearance on the safe side of rounding, metres.
constexpr double kSlack = 1e-6;
/// A walker whose centre is taken to be inside a wall is put back this far into the room, metres.
constexpr double kNudge = 0.05;

bool inside_loop(const std::vector<Vec2>& loop, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Vec2 a = loop[i];
    const Vec2 b = loop[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool odd_crossings(const std::vector<Segment>& walls, Vec2 p, Vec2 unit) {
  bool odd = false;
  for (const Segment& wall : walls) {
    // Half-open by side, so that a ray through a joint of two walls counts it once.
    const double a = cross(unit, wall.a - p);
    const double b = cross(unit, wall.b - p);
    if ((a > 0.0) == (b > 0.0)) continue;
    const Vec2 hit = wall.a + (a / (a - b)) * wall.direction();
    if (dot(hit - p, unit) > 0.0) odd = !odd;
  }
  return odd;
}

}  // namespace

FreeSpace::FreeSpace(const Building& building, RoomIndex room)
    : room_(&building.room(room)), openings_(routing::find_openings(building, room)) {
  routing::CutWalls cut = routing::cut_openings(room_->walls, openings_);
  cut.walls.insert(cut.walls.end(), room_->reflectors.begin(), room_->reflectors.end());
  solids_ = SegmentTree(std::move(cut.walls));
  doorways_ = std::move(cut.doorways);
  for (Opening& opening : openings_) {
    for (const double step : {0.1, 0.25, 0.5}) {
      const bool front = contains(opening.centre + step * opening.inward);
      const bool back = contains(opening.centre - step * opening.inward);
      if (front == back) continue;
      if (back) opening.inward = -opening.inward;
      break;
    }
  }
}

bool FreeSpace::contains(Vec2 p) const noexcept {
  if (!room_->boundary.empty()) {
    bool inside = false;
    for (const auto& loop : room_->boundary) {
      if (!loop.empty() && inside_loop(loop, p)) inside = !inside;
    }
    return inside;
  }
  // Directions off the axes and off each other's multiples: plans are mostly axis-parallel.
  static const std::array<Vec2, 3> kRays = {unit_from_angle(0.317), unit_from_angle(2.411), unit_from_angle(-1.753)};
  int votes = 0;
  for (const Vec2 unit : kRays) votes += odd_crossings(room_->walls, p, unit) ? 1 : 0;
  return votes >= 2;
}

bool FreeSpace::crosses_doorway(const Segment& s) const noexcept {
  return std::any_of(doorways_.begin(), doorways_.end(), [&](const Segment& d) { return intersects(d, s); });
}

bool FreeSpace::clear(Vec2 a, Vec2 b, double radius) const noexcept {
  const Segment way{a, b};
  const double needed = radius - kSlack;
  return solids_.all_near(way, radius, [&](const Segment& s) { return segment_distance(s, way) >= needed; }) &&
         !crosses_doorway(way);
}

bool FreeSpace::keeps_away(const Segment& way, double radius) const noexcept {
  return solids_.all_near(way, radius, [&](const Segment& s) {
    const double apart = segment_distance(s, way);
    if (apart >= radius - kSlack) return true;
    return apart > 0.0 && apart >= std::min(distance(s, way.a), distance(s, way.b)) - kSlack;
  });
}

bool FreeSpace::clear_between(Vec2 a, Vec2 b, double radius) const noexcept {
  return keeps_away({a, b}, radius) && !crosses_doorway({a, b});
}

bool FreeSpace::clear_to_door(Vec2 a, const Opening& opening, double radius) const noexcept {
  return keeps_away({a, opening.centre}, radius);
}

Vec2 FreeSpace::settle(Vec2 p, double radius) const noexcept {
  if (!contains(p)) {
    const auto wall = nearest_solid(p);
    if (wall.segment >= 0) {
      const Vec2 outward = p - wall.point;
      const double off = norm(outward);
      const Vec2 normal = solids()[static_cast<std::size_t>(wall.segment)].direction();
      const Vec2 inward = off > 1e-9 ? (-1.0 / off) * outward : (1.0 / norm(normal)) * perpendicular(normal);
      for (const double sign : {1.0, -1.0}) {
        const Vec2 q = wall.point + sign * kNudge * inward;
        if (contains(q)) {
          p = q;
          break;
        }
      }
    }
  }
  Vec2 best = p;
  double best_clearance = clearance(p);
  constexpr int kPushes = 24;
  for (int i = 0; i < kPushes && best_clearance < radius; ++i) {
    const auto wall = nearest_solid(p);
    if (wall.segment < 0) break;
    Vec2 away = p - wall.point;
    double apart = norm(away);
    if (apart < 1e-9) {
      away = perpendicular(solids()[static_cast<std::size_t>(wall.segment)].direction());
      apart = norm(away);
      if (!(apart > 0.0)) break;
      if (!contains(p + (kNudge / apart) * away)) away = -away;
      p = p + (kNudge / apart) * away;
      apart = kNudge;
    } else {
      p = p + ((radius - apart) / apart + 1e-6) * away;
    }
    const double now = clearance(p);
    if (now > best_clearance && contains(p)) {
      best = p;
      best_clearance = now;
    }
  }
  return best;
}

}  // namespace echoway
