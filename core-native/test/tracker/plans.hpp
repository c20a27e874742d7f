#pragma once

#include <string>
#include <utility>
#include <vector>

#include "echoway/building/building.hpp"

/// Small buildings for the tracker's tests.
namespace echoway::test {

/// A room from its outline, counter-clockwise, in its own frame.
inline Room room_from_outline(std::string id, std::vector<Vec2> outline) {
  Room room;
  room.id = std::move(id);
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = outline[(i + n - 1) % n], at = outline[i], after = outline[(i + 1) % n];
    room.walls.push_back({at, after});
    (cross(at - before, after - at) > 0.0 ? room.corners : room.edges).push_back(at);
  }
  room.boundary.push_back(std::move(outline));
  return room;
}

/// Rooms one above the other, a level each, without walls.
inline Building storeys(int count) {
  Building b;
  for (int level = 0; level < count; ++level) {
    Room room;
    room.id = std::to_string(level);
    room.level = level;
    b.rooms.push_back(room);
  }
  return b;
}

inline constexpr Vec2 kFarCorner{8.0, 3.0};

/// A rectangle from the origin to kFarCorner: it looks the same both ways round.
inline Building plain_hall() {
  Building b;
  b.rooms.push_back(room_from_outline("hall", {{0, 0}, {kFarCorner.x, 0}, kFarCorner, {0, kFarCorner.y}}));
  return b;
}

inline void join(Building& b, RoomIndex x, RoomIndex y, Vec2 on_level, double width = 0.95) {
  const auto in = [&](RoomIndex room) { return b.room(room).frame.inverse_transform(on_level); };
  b.doors.push_back({x, in(x), y, in(y), width});
}

/// An L-shaped office, a smaller one beside it, and a hall along both.
inline Building small_office() {
  Building b;
  b.name = "small office";
  b.rooms.push_back(room_from_outline("hall", {{0, 0}, {10, 0}, {10, 2}, {0, 2}}));
  b.rooms.push_back(room_from_outline("A", {{0, 0}, {5.6, 0}, {5.6, 3.1}, {3.9, 3.1}, {3.9, 5.2}, {0, 5.2}}));
  b.rooms.push_back(room_from_outline("B", {{0, 0}, {4.4, 0}, {4.4, 3.6}, {0, 3.6}}));
  b.rooms[1].frame.position = {0, 2};
  b.rooms[2].frame.position = {5.6, 2};
  join(b, 1, 0, {1.4, 2});
  join(b, 2, 0, {8.7, 2});
  return b;
}

}  // namespace echoway::test
