#include "buildings.hpp"

#include <cmath>
#include <string>

#include "echoway/random.hpp"

namespace echoway::eval {
namespace {

// A room from its outline, counter-clockwise.
Room room_from_outline(std::string id, std::vector<Vec2> outline) {
  Room room;
  room.id = std::move(id);
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = outline[(i + n - 1) % n], at = outline[i], after = outline[(i + 1) % n];
    room.walls.push_back({at, after});
    const double turn = cross(at - before, after - at);
    if (turn > 1e-9) room.corners.push_back(at);
    if (turn < -1e-9) room.edges.push_back(at);
  }
  room.boundary.push_back(std::move(outline));
  return room;
}

void join(Building& b, RoomIndex x, Vec2 level_x, RoomIndex y, double width) {
  Door d;
  d.room_a = x;
  d.at_a = b.room(x).frame.inverse_transform(level_x);
  d.room_b = y;
  d.at_b = b.room(y).frame.inverse_transform(level_x);
  d.width = width;
  b.doors.push_back(d);
}

}  // namespace

Building random_office(int rooms_per_side, std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  Building b;
  b.name = "office";
  const double hall_width = random.uniform(1.6, 3.0);
  std::vector<std::pair<double, RoomIndex>> doors;
  double length = 0.0;
  struct Plan { double x, w, d; bool up; };
  std::vector<Plan> plans;
  for (const bool up : {true, false}) {
    double x = 0.0;
    for (int i = 0; i < rooms_per_side; ++i) {
      const double w = random.uniform(2.8, 6.5);
      plans.push_back({x, w, random.uniform(2.8, 6.5), up});
      x += w;
    }
    length = std::max(length, x);
  }
  b.rooms.push_back(room_from_outline("hall", {{0, 0}, {length, 0}, {length, hall_width}, {0, hall_width}}));
  int number = 1;
  RoomIndex previous = kNoRoom;
  for (const Plan& p : plans) {
    std::vector<Vec2> outline{{0, 0}, {p.w, 0}, {p.w, p.d}, {0, p.d}};
    if (random.uniform() < 0.35) {
      const double cx = random.uniform(0.8, 0.4 * p.w), cy = random.uniform(0.8, 0.4 * p.d);
      outline =
          p.up ? std::vector<Vec2>{{0, 0}, {p.w, 0}, {p.w, p.d - cy}, {p.w - cx, p.d - cy}, {p.w - cx, p.d}, {0, p.d}}
               : std::vector<Vec2>{{0, 0}, {p.w - cx, 0}, {p.w - cx, cy}, {p.w, cy}, {p.w, p.d}, {0, p.d}};
    }
    Room room = room_from_outline("r" + std::to_string(number++), outline);
    room.frame.position = {p.x, p.up ? hall_width : -p.d};
    if (random.uniform() < 0.2) {
      const double bx = random.uniform(0.3, p.w - 2.2), by = p.d * 0.5;
      room.reflectors.push_back({{bx, by}, {bx + 1.6, by}});
    }
    const auto index = static_cast<RoomIndex>(b.rooms.size());
    b.rooms.push_back(room);
    // GCC's order of arguments, spelt out: every compiler shall make the same building.
    const double width = random.uniform(0.8, 1.1);
    join(b, index, {p.x + random.uniform(0.8, p.w - 0.8), p.up ? hall_width : 0.0}, 0, width);
    if (previous != kNoRoom && p.x > 0.0 && random.uniform() < 0.2) {
      const double y = p.up ? hall_width + 1.4 : -1.4;
      join(b, previous, {p.x, y}, index, 0.9);
    }
    previous = index;
  }
  return b;
}

Building twin_rooms(int rooms) {
  Building b;
  b.name = "twins";
  const double w = 4.0, d = 5.0, hall = 2.0;
  b.rooms.push_back(room_from_outline("hall", {{0, 0}, {rooms * w, 0}, {rooms * w, hall}, {0, hall}}));
  for (int i = 0; i < rooms; ++i) {
    Room room = room_from_outline("t" + std::to_string(i + 1), {{0, 0}, {w, 0}, {w, d}, {0, d}});
    room.frame.position = {i * w, hall};
    b.rooms.push_back(room);
    join(b, static_cast<RoomIndex>(i + 1), {i * w + 1.2, hall}, 0, 0.95);
  }
  return b;
}

}  // namespace echoway::eval
