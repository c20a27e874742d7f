#include "building_promises.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "echoway/geometry/inclusion.hpp"

namespace echoway::fuzz {
namespace {

bool finite(const std::vector<Segment>& segments) {
  return std::all_of(segments.begin(), segments.end(),
                     [](const Segment& s) { return is_finite(s.a) && is_finite(s.b); });
}
bool finite(const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec2 p) { return is_finite(p); });
}

std::string check_room(const Room& room) {
  const bool all_finite =
      finite(room.walls) && finite(room.reflectors) && finite(room.corners) && finite(room.edges) &&
      is_finite(room.frame) &&
      std::all_of(room.boundary.begin(), room.boundary.end(), [](const auto& l) { return finite(l); });
  if (!all_finite) return "a room has something that is not finite";
  if (room.boundary.empty()) return "a room without a floor";
  for (std::size_t i = 0; i < room.boundary.size(); ++i) {
    if (room.boundary[i].size() < 3) return "a loop of fewer than three points";
    const double area = signed_area(room.boundary[i]);
    if (i == 0 ? !(area > 0.0) : !(area < 0.0)) return "a loop that runs the wrong way round";
  }
  return "";
}

}  // namespace

std::string check_building_promises(const Building& building) {
  if (building.rooms.empty()) return "a building without a room";
  for (const Room& room : building.rooms) {
    if (std::string broken = check_room(room); !broken.empty()) return broken;
  }
  for (const Door& door : building.doors) {
    if (!building.has_room(door.room_a) || !building.has_room(door.room_b)) return "a door to no room";
    if (!is_finite(door.at_a) || !is_finite(door.at_b) || !(door.width > 0.0) || !std::isfinite(door.width)) {
      return "a door that is not finite";
    }
  }
  for (const LevelLink& link : building.links) {
    if (!building.has_room(link.room_a) || !building.has_room(link.room_b)) return "stairs to no room";
  }
  for (const auto* landmarks : {&building.exits, &building.places}) {
    for (const Landmark& landmark : *landmarks) {
      if (!building.has_room(landmark.room) || !is_finite(landmark.at)) return "a place that is nowhere";
    }
  }
  for (const LoopClosure& closure : building.loop_closures) {
    if (closure.door >= building.doors.size() || !std::isfinite(closure.error)) return "a loop that is not finite";
  }
  return "";
}

}  // namespace echoway::fuzz
