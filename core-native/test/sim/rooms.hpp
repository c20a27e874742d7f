#pragma once

#include <string>
#include <vector>

#include "echoway/sim/simulate.hpp"
#include "support/rooms.hpp"

// Buildings made in memory, so that tests of the simulator need no files.
namespace echoway::sim {

inline Room box_room(std::string id, Vec2 origin, double width, double height) {
  Room room = rooms::rectangle(width, height);
  room.id = std::move(id);
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

inline Building one_room(Room room) {
  Building building;
  room.id = "P";
  building.rooms = {std::move(room)};
  return building;
}

/// What a single sensor on the wearer's axis (radius 0) reads that looks along `degrees_off_x`.
inline double look(const Building& building, const World& world, Vec2 from, double degrees_off_x,
                   std::uint64_t seed = 1, const std::string& room = "") {
  Ring ring;
  ring.belt.radius_m = 0.0;
  ring.bearings_rad = {0.0};
  const std::string where = room.empty() ? building.rooms[0].id : room;
  const auto log = scan_at(building, world, ring, {{0.0, where, {from, degrees(degrees_off_x)}}}, seed);
  return log.ok() ? log->firings.at(0).range_m : -2.0;
}

}  // namespace echoway::sim
