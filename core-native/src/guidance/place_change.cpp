#include "guidance/place_change.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace echoway::guidance {

bool is_place(const Building& building, const Estimate& e) noexcept {
  return building.has_room(e.room) && is_finite(e.pose);
}

double least_walk(const Router& router, const Estimate& from, const Estimate& to) noexcept {
  if (from.room == to.room) return distance(from.pose.position, to.pose.position);
  double least = std::numeric_limits<double>::infinity();
  for (const Door& door : router.building().doors) {
    const bool there = door.room_a == from.room && door.room_b == to.room;
    const bool back = door.room_b == from.room && door.room_a == to.room;
    if (!there && !back) continue;
    const Vec2 leaves = there ? door.at_a : door.at_b;
    const Vec2 enters = there ? door.at_b : door.at_a;
    least = std::min(least, distance(from.pose.position, leaves) + distance(enters, to.pose.position));
  }
  return least;
}

}  // namespace echoway::guidance
