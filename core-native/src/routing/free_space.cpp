#include "echoway/routing/free_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "echoway/geometry/inclusion.hpp"

namespace echoway {
namespace {

/// Slack that keeps a way exactly at the wanted clearance on the safe side of rounding, metres.
constexpr double kSlack = 1e-6;
/// A walker whose centre is taken to be inside a wall is put back this far into the room, metres.
constexpr double kNudge = 0.05;

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

FreeSpace::FreeSpace(const Building& building, RoomIndex room) : room_(&building.room(room)) {
  std::vector<DoorOpening> openings;
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    const auto index = static_cast<std::int32_t>(i);
    if (door.room_a == room) add_passage(door, index, door.at_a, openings);
    if (door.room_b == room) add_passage(door, index, door.at_b, openings);
  }
  std::vector<Segment> solids = walls_with_doors_open(*room_, openings);
  solids.insert(solids.end(), room_->reflectors.begin(), room_->reflectors.end());
  solids_ = SegmentTree(std::move(solids));
}

void FreeSpace::add_passage(const Door& door, std::int32_t index, Vec2 at, std::vector<DoorOpening>& openings) {
  Passage passage{index, at, {}};
  const std::optional<DoorOpening> opening = find_opening(*room_, at, door.width);
  if (opening && opening->span.length() > 0.0) {
    openings.push_back(*opening);
    openings.back().door = static_cast<std::size_t>(index);
    doorways_.push_back(opening->span);
    passage.centre = 0.5 * (opening->span.a + opening->span.b);
    const Vec2 normal = (1.0 / opening->span.length()) * perpendicular(opening->span.direction());
    passage.inward = normal;
    for (const double step : {0.1, 0.25, 0.5}) {
      const bool front = contains(passage.centre + step * normal);
      const bool back = contains(passage.centre - step * normal);
      if (front == back) continue;
      passage.inward = front ? normal : -normal;
      break;
    }
  }
  passages_.push_back(passage);
}

bool FreeSpace::contains(Vec2 p) const noexcept {
  if (!room_->boundary.empty()) return classify(room_->boundary, p) == Inclusion::inside;
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

bool FreeSpace::clear_to_door(Vec2 a, const Passage& passage, double radius) const noexcept {
  return keeps_away({a, passage.centre}, radius);
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
      // From a corner the first nudge runs along the other wall, which is not outside.
      const Vec2 nudged = p + (kNudge / apart) * away;
      const bool outside = room_->boundary.empty() ? !contains(nudged) : !echoway::contains(room_->boundary, nudged);
      if (outside) away = -away;
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
