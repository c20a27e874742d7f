#include "building/phrases.hpp"

#include "text/format.hpp"

namespace echoway {

std::string room_label(const Building& building, RoomIndex room) { return "room " + building.room(room).id; }

std::string door_label(const Building& building, const Door& door) {
  return "the door between rooms '" + building.room(door.room_a).id + "' and '" + building.room(door.room_b).id + "'";
}

std::string Phrases::length(double metres) const {
  return text::brief(metres / metres_per(unit_)) + (unit_ == LengthUnit::feet ? " ft" : " m");
}

std::string Phrases::area(double square_metres) const {
  const double unit = metres_per(unit_);
  return text::brief(square_metres / (unit * unit)) + (unit_ == LengthUnit::feet ? " square ft" : " square m");
}

std::string Phrases::point(Vec2 metres) const {
  return "(" + text::brief(metres.x / metres_per(unit_)) + ", " + text::brief(metres.y / metres_per(unit_)) + ")";
}

}  // namespace echoway
