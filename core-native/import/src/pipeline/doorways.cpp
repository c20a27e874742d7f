#include "pipeline/doorways.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/segment.hpp"

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kTolerance = 0.03;      // metres; where that moves a wall by more than kMostMoved, a third of it
constexpr double kMostMoved = 0.045;     // metres; the crevices smoothed before and the grid take the rest of 5 cm
constexpr int kAttempts = 4;
constexpr double kSample = 0.1;          // metres between the points of a wall that are looked at
constexpr double kSpike = 0.02;          // metres; half the width of spikes and slits that growing may leave
constexpr double kBeside = 0.03;         // metres from a door to the wall that it is in
constexpr double kLeastOpening = 0.4;    // metres
constexpr double kLeastOverlap = 0.02;   // metres, besides what simplification may have moved the walls on both sides
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

void grow_through(std::vector<Shape>& rooms, const PlacedDoor& door, double overlap) {
  if (door.to_front + door.to_back < kThinWall) return;
  const int shallow = shallow_is_front(door, rooms) ? door.front : door.back;
  const int deep = shallow == door.front ? door.back : door.front;
  Shape reveal = geos::rectangle(door.centre, door.along, 0.5 * door.width, door.to_back + overlap,
                                 door.to_front + overlap);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (i != index(deep) && geos::intersects(reveal, rooms[i])) reveal = geos::difference(reveal, rooms[i]);
  }
  if (!door.drawn.empty()) {
    // A door that is drawn askew does not fill its rectangle, and what else lies in it is wall.
    const Shape within = geos::intersection(reveal, geos::grow(door.drawn, kTolerance));
    const bool joins = !within.empty() && geos::distance(within, rooms[index(deep)]) < kThinWall &&
                       geos::distance(within, rooms[index(shallow)]) < kThinWall;
    if (joins) reveal = within;
  }
  rooms[index(deep)] = largest(geos::unite({rooms[index(deep)], reveal}));
}

// Takes off what is thinner than twice `spike`, of the floor and of the walls around it.
Shape tidy(const Shape& room, double spike) {
  const Shape opened = geos::grow(geos::grow(room, -spike), spike);
  const Shape closed = geos::grow(geos::grow(opened, spike), -spike);
  return largest(geos::simplify(closed, spike));
}

// The rooms with their vertices thinned out and the doorways' depth given to the smaller of two rooms.
std::vector<Shape> with_doorways(const std::vector<Shape>& given, const std::vector<PlacedDoor>& doors,
                                 const std::vector<double>& tolerance) {
  std::vector<Shape> rooms = given;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (tolerance[i] > 0.0) rooms[i] = largest(geos::simplify(rooms[i], tolerance[i]));
  }
  for (const PlacedDoor& door : doors) {
    const double play = std::max(tolerance[index(door.front)], tolerance[index(door.back)]);
    grow_through(rooms, door, play > 0.0 ? kLeastOverlap + 2.0 * play : 0.002);
  }
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (tolerance[i] > 0.0) rooms[i] = tidy(rooms[i], std::min(kSpike, tolerance[i]));
  }
  return rooms;
}

std::vector<Segment> walls_of(const Shape& room) {
  std::vector<Segment> walls;
  for (const Path& ring : geos::to_paths(geos::boundary(room))) {
    for (std::size_t i = 1; i < ring.size(); ++i) walls.push_back({ring[i - 1], ring[i]});
  }
  return walls;
}

// True when a wall of `room` lies further than kMostMoved from every wall of `faithful`.
bool moved(const Shape& room, const Shape& faithful) {
  const std::vector<Segment> walls = walls_of(faithful);
  for (const Segment& wall : walls_of(room)) {
    const int pieces = 1 + static_cast<int>(wall.length() / kSample);
    for (int k = 0; k < pieces; ++k) {
      const Vec2 at = wall.a + (static_cast<double>(k) / pieces) * wall.direction();
      const auto near = [&](const Segment& other) { return distance(other, at) <= kMostMoved; };
      if (std::none_of(walls.begin(), walls.end(), near)) return true;
    }
  }
  return false;
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
  const std::vector<Shape> given = rooms;
  const std::vector<Shape> faithful = with_doorways(given, doors, std::vector<double>(given.size(), 0.0));
  std::vector<double> tolerance(given.size(), kTolerance);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    rooms = with_doorways(given, doors, tolerance);
    bool good = true;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (!moved(rooms[i], faithful[i])) continue;
      tolerance[i] /= 3.0;
      good = false;
    }
    if (good) break;
  }
  for (Shape& room : rooms) room = largest(room);
  std::vector<DoorSite> sites;
  for (const PlacedDoor& door : doors) sites.push_back(site_of(door, shallow_is_front(door, given), rooms));
  return sites;
}

}  // namespace echoway::import
