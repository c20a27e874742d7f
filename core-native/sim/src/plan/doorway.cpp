#include "plan/doorway.hpp"

#include <cmath>
#include <limits>

namespace echoway::sim {
namespace {

Doorway one_side(const Building& building, std::size_t index, bool a_side) {
  const Door& door = building.doors[index];
  const Room& room = building.room(a_side ? door.room_a : door.room_b);
  const Vec2 at = a_side ? door.at_a : door.at_b;
  Doorway doorway;
  doorway.door = index;
  doorway.other = a_side ? door.room_b : door.room_a;
  doorway.width = door.width;
  doorway.centre = doorway.middle = at;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& wall : room.walls) {
    const double length = wall.length();
    const double d = distance(wall, at);
    if (!(length > 0.0) || d >= nearest) continue;
    nearest = d;
    doorway.centre = nearest_point(wall, at);
    doorway.along = (1.0 / length) * wall.direction();
  }
  doorway.inward = perpendicular(doorway.along);
  if (!inside(room, doorway.centre + 0.2 * doorway.inward)) doorway.inward = -doorway.inward;
  return doorway;
}

// Where the other room's frame lies in this room's: rotation from the level's frames, translation from the door, because
// a chain of doors need not close to the centimetre and the wearer must not jump.
Pose2 place_other(const Room& room, const Doorway& here, const Room& other, const Doorway& there) {
  Pose2 frame{{}, wrap_angle(other.frame.heading - room.frame.heading)};
  frame.position = here.middle - frame.transform(there.middle);
  return frame;
}

}  // namespace

bool inside(const Room& room, Vec2 p) noexcept {
  bool in = false;
  for (const std::vector<Vec2>& loop : room.boundary) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2 a = loop[i];
      const Vec2 b = loop[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
    }
  }
  return in;
}

double floor_area(const Room& room) noexcept {
  double area = 0.0;
  for (const std::vector<Vec2>& loop : room.boundary) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) area += 0.5 * cross(loop[j], loop[i]);
  }
  return std::abs(area);
}

std::vector<std::vector<Doorway>> find_doorways(const Building& building) {
  std::vector<std::vector<Doorway>> doorways(building.rooms.size());
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    if (door.room_a == kNoRoom || door.room_b == kNoRoom || door.room_a == door.room_b) continue;
    auto& of_a = doorways[static_cast<std::size_t>(door.room_a)];
    auto& of_b = doorways[static_cast<std::size_t>(door.room_b)];
    of_a.push_back(one_side(building, i, true));
    of_b.push_back(one_side(building, i, false));
    of_a.back().twin = of_b.size() - 1;
    of_b.back().twin = of_a.size() - 1;
    of_a.back().other_frame =
        place_other(building.room(door.room_a), of_a.back(), building.room(door.room_b), of_b.back());
    of_b.back().other_frame =
        place_other(building.room(door.room_b), of_b.back(), building.room(door.room_a), of_a.back());
  }
  return doorways;
}

}  // namespace echoway::sim
