#pragma once

#include <string>

#include "echoway/building/building.hpp"

// Buildings made in memory, so that tests of the simulator need no files.
namespace echoway::sim {

inline Room box_room(std::string id, Vec2 origin, double width, double height) {
  Room room;
  room.id = std::move(id);
  room.walls = {{{0.0, 0.0}, {width, 0.0}},
                {{width, 0.0}, {width, height}},
                {{width, height}, {0.0, height}},
                {{0.0, height}, {0.0, 0.0}}};
  room.boundary = {{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}};
  room.frame.position = origin;
  return room;
}

/// A hall of 5 x 4 m, an office of 6 x 7 m to its right and a store of 5 x 3 m above the hall, reached by the office.
inline Building three_rooms() {
  Building building;
  building.rooms = {box_room("hall", {0.0, 0.0}, 5.0, 4.0), box_room("office", {5.0, 0.0}, 6.0, 7.0),
                    box_room("store", {0.0, 4.0}, 5.0, 3.0)};
  building.doors = {{0, {5.0, 2.0}, 1, {0.0, 2.0}, 0.9}, {1, {0.0, 5.5}, 2, {5.0, 1.5}, 0.9}};
  return building;
}

}  // namespace echoway::sim
