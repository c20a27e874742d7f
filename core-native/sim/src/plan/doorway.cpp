#include "plan/doorway.hpp"

#include <cmath>
#include <optional>

#include "echoway/building/opening.hpp"
#include "echoway/geometry/inclusion.hpp"

namespace echoway::sim {
namespace {

constexpr double kProbe = 0.2;      // How far from a wall its inner side is looked for, metres.
constexpr double kNarrowest = 0.3;  // Nobody fits through a narrower opening, metres.

std::optional<Doorway> one_side(const Room& room, Vec2 at, const Door& door) {
  const std::optional<DoorOpening> opening = find_opening(room, at, door.width);
  if (!opening || opening->span.length() < kNarrowest) return std::nullopt;
  Doorway doorway;
  doorway.opening = opening->span;
  doorway.inward = perpendicular(doorway.along());
  if (!contains(room.boundary, doorway.centre() + kProbe * doorway.inward)) doorway.inward = -doorway.inward;
  const Vec2 off_wall = dot(at - doorway.centre(), doorway.inward) * doorway.inward;
  doorway.threshold = {doorway.opening.a + off_wall, doorway.opening.b + off_wall};
  return doorway;
}

// Where the other room's frame lies in this room's: rotation from the level's frames, translation from the door,
// because a chain of doors need not close to the centimetre and the wearer must not jump.
Pose2 place_other(const Room& room, Vec2 at, const Room& other, Vec2 at_other) {
  Pose2 frame{{}, wrap_angle(other.frame.heading - room.frame.heading)};
  frame.position = at - frame.transform(at_other);
  return frame;
}

}  // namespace

double floor_area(const Room& room) noexcept {
  double area = 0.0;
  for (const std::vector<Vec2>& loop : room.boundary) area += signed_area(loop);
  return std::abs(area);
}

std::vector<std::vector<Doorway>> find_doorways(const Building& building) {
  std::vector<std::vector<Doorway>> doorways(building.rooms.size());
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    if (door.room_a == kNoRoom || door.room_b == kNoRoom || door.room_a == door.room_b) continue;
    const Room& a = building.room(door.room_a);
    const Room& b = building.room(door.room_b);
    std::optional<Doorway> of_a = one_side(a, door.at_a, door);
    std::optional<Doorway> of_b = one_side(b, door.at_b, door);
    if (!of_a || !of_b) continue;
    std::vector<Doorway>& in_a = doorways[static_cast<std::size_t>(door.room_a)];
    std::vector<Doorway>& in_b = doorways[static_cast<std::size_t>(door.room_b)];
    of_a->door = of_b->door = i;
    of_a->other = door.room_b;
    of_b->other = door.room_a;
    of_a->twin = in_b.size();
    of_b->twin = in_a.size();
    of_a->other_frame = place_other(a, door.at_a, b, door.at_b);
    of_b->other_frame = place_other(b, door.at_b, a, door.at_a);
    in_a.push_back(*of_a);
    in_b.push_back(*of_b);
  }
  return doorways;
}

}  // namespace echoway::sim
