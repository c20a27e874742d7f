#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"

namespace echoway::test {

/// A room whose walls run around `outline` (metres, counter-clockwise), with its boundary filled in.
inline Room make_room(std::string id, std::vector<Vec2> outline, std::string name = {}) {
  Room room;
  room.id = std::move(id);
  room.name = std::move(name);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    room.walls.push_back({outline[i], outline[(i + 1) % outline.size()]});
  }
  room.boundary.push_back(std::move(outline));
  return room;
}

inline Room make_box(std::string id, double width, double depth, std::string name = {}) {
  return make_room(std::move(id), {{0, 0}, {width, 0}, {width, depth}, {0, depth}}, std::move(name));
}

/// A free-standing closed obstacle: its walls, and a hole in the boundary.
inline void add_pillar(Room& room, Vec2 low, Vec2 high) {
  const std::vector<Vec2> loop = {low, {low.x, high.y}, high, {high.x, low.y}};
  for (std::size_t i = 0; i < loop.size(); ++i) room.walls.push_back({loop[i], loop[(i + 1) % loop.size()]});
  room.boundary.push_back(loop);
}

inline void add_door(Building& b, RoomIndex room_a, Vec2 at_a, RoomIndex room_b, Vec2 at_b, double width = 0.9) {
  b.doors.push_back({room_a, at_a, room_b, at_b, width});
}

/// `columns` x `rows` square rooms of `size` metres, each joined to its right and upper neighbour.
inline Building make_grid(int columns, int rows, double size = 5.0) {
  Building b;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      b.rooms.push_back(make_box(std::to_string(y * columns + x), size, size));
      b.rooms.back().frame.position = {x * size, y * size};
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const RoomIndex here = y * columns + x;
      if (x + 1 < columns) add_door(b, here, {size, size / 2}, here + 1, {0, size / 2});
      if (y + 1 < rows) add_door(b, here, {size / 2, size}, here + columns, {size / 2, 0});
    }
  }
  return b;
}

/// A hall along x with `count` offices above and below it; 2 * count + 1 rooms, the hall is room 0.
inline Building make_office_floor(int count, double office = 4.0, double hall_width = 2.4) {
  Building b;
  b.rooms.push_back(make_box("hall", count * office, hall_width, "hall"));
  for (int i = 0; i < 2 * count; ++i) {
    const bool above = i < count;
    const int column = above ? i : i - count;
    b.rooms.push_back(make_box(std::string("o").append(std::to_string(i)), office, office));
    b.rooms.back().frame.position = {column * office, above ? hall_width : -office};
    const double x = column * office + office / 3;
    add_door(b, 0, {x, above ? hall_width : 0.0}, i + 1, {office / 3, above ? 0.0 : office});
  }
  return b;
}

}  // namespace echoway::test
