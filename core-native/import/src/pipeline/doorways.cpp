#include "pipeline/doorways.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/segment.hpp"

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kTolerance = 0.03;      // metres; with the crevices smoothed before, no wall moves by 5 cm
constexpr double kSpike = 0.02;          // metres; half the width of spikes and slits that growing may leave
constexpr double kBeside = 0.03;         // metres from a door to the wall that it is in
constexpr double kLeastOpening = 0.4;    // metres
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

// Takes off what is thinner than twice kSpike, of the floor and of the walls around it.
Shape tidy(const Shape& room) {
  const Shape opened = geos::grow(geos::grow(room, -kSpike), kSpike);
  const Shape closed = geos::grow(geos::grow(opened, kSpike), -kSpike);
  return largest(geos::simplify(closed, kSpike));
}

// Cuts the stretch [low, high] along a door down to the straight wall of `room` that it is in.
void clip_to_wall(const Shape& room, Vec2 at, Vec2 along, double& low, double& high) {
  Segment best{};
  double most_parallel = -1.0;
  for (const Path& ring : geos::to_paths(geos::boundary(room))) {
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const Segment wall{ring[i - 1], ring[i]};
      const double parallel = std::abs(dot(wall.direction(), along)) / wall.length();
      if (distance(wall, at) > kBeside || parallel <= most_parallel) continue;
      most_parallel = parallel;
      best = wall;
    }
  }
  if (most_parallel < 0.0) return;
  const auto [from, to] = std::minmax({dot(best.a - at, along), dot(best.b - at, along)});
  low = std::max(low, from);
  high = std::min(high, to);
}

DoorSite site_of(const PlacedDoor& door, bool front, const std::vector<Shape>& rooms) {
  const Shape& shallow = rooms[index(front ? door.front : door.back)];
  const Shape& deep = rooms[index(front ? door.back : door.front)];
  const Vec2 n = perpendicular(door.along);
  const Vec2 face = front ? door.centre + door.to_front * n : door.centre - door.to_back * n;
  const Vec2 at = geos::nearest_on(geos::boundary(shallow), face);
  double low = -0.5 * door.width, high = 0.5 * door.width;
  clip_to_wall(shallow, at, door.along, low, high);
  clip_to_wall(deep, at, door.along, low, high);
  if (high - low < kLeastOpening) return {at, door.width};
  return {geos::nearest_on(geos::boundary(shallow), at + (0.5 * (low + high)) * door.along), high - low};
}

}  // namespace

std::vector<DoorSite> open_doorways(std::vector<Shape>& rooms, const std::vector<PlacedDoor>& doors) {
  for (Shape& room : rooms) room = largest(geos::simplify(room, kTolerance));
  const std::vector<Shape> before = rooms;
  for (const PlacedDoor& door : doors) grow_through(rooms, door);
  for (Shape& room : rooms) room = tidy(room);
  std::vector<DoorSite> sites;
  for (const PlacedDoor& door : doors) sites.push_back(site_of(door, shallow_is_front(door, before), rooms));
  return sites;
}

}  // namespace echoway::import
