#include "pipeline/doorways.hpp"

#include <algorithm>

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kTolerance = 0.03;      // metres; with the crevices smoothed before, no wall moves by 5 cm
constexpr double kCollinear = 0.002;     // metres; vertices that make no bend
constexpr double kOverlap = 0.08;        // metres; more than simplification may have moved a wall
constexpr double kThinWall = 0.01;       // metres; rooms this near touch already

std::size_t index(int cell) { return static_cast<std::size_t>(cell); }

Shape largest(const Shape& shape) {
  std::vector<Shape> parts = geos::areas(shape);
  return *std::max_element(parts.begin(), parts.end(),
                           [](const Shape& a, const Shape& b) { return a.area() < b.area(); });
}

bool shallow_is_front(const PlacedDoor& door, const std::vector<Shape>& rooms) {
  return rooms[index(door.front)].area() >= rooms[index(door.back)].area();
}

void grow_through(std::vector<Shape>& rooms, const PlacedDoor& door) {
  if (door.to_front + door.to_back < kThinWall) return;
  const int shallow = shallow_is_front(door, rooms) ? door.front : door.back;
  const int deep = shallow == door.front ? door.back : door.front;
  Shape reveal = geos::rectangle(door.centre, door.along, 0.5 * door.width, door.to_back + kOverlap,
                                 door.to_front + kOverlap);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (i != index(deep) && geos::intersects(reveal, rooms[i])) reveal = geos::difference(reveal, rooms[i]);
  }
  rooms[index(deep)] = largest(geos::unite({rooms[index(deep)], reveal}));
}

}  // namespace

std::vector<Vec2> open_doorways(std::vector<Shape>& rooms, const std::vector<PlacedDoor>& doors) {
  for (Shape& room : rooms) room = largest(geos::simplify(room, kTolerance));
  const std::vector<Shape> before = rooms;
  for (const PlacedDoor& door : doors) grow_through(rooms, door);
  for (Shape& room : rooms) room = largest(geos::simplify(room, kCollinear));
  std::vector<Vec2> places;
  for (const PlacedDoor& door : doors) {
    const bool front = shallow_is_front(door, before);
    const Vec2 n = perpendicular(door.along);
    const Vec2 face = front ? door.centre + door.to_front * n : door.centre - door.to_back * n;
    places.push_back(geos::nearest_on(geos::boundary(rooms[index(front ? door.front : door.back)]), face));
  }
  return places;
}

}  // namespace echoway::import
