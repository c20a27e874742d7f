#include "plans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "echoway/building/loader.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/random.hpp"

namespace echoway::report {
namespace {

constexpr double kSamePlane = 1e-3;  // Metres: coordinates this close belong to one wall.

// Moves every coordinate of one axis with the wall that it is nearest to.
class Shift {
 public:
  void add(double coordinate) {
    if (planes_.empty() || std::abs(nearest(coordinate).first - coordinate) > kSamePlane) planes_[coordinate] = 0.0;
  }
  [[nodiscard]] std::map<double, double>& planes() { return planes_; }
  [[nodiscard]] double apply(double x) const { return planes_.empty() ? x : x + nearest(x).second; }

 private:
  [[nodiscard]] std::pair<double, double> nearest(double x) const {
    return *std::min_element(planes_.begin(), planes_.end(), [x](const auto& a, const auto& b) {
      return std::abs(a.first - x) < std::abs(b.first - x);
    });
  }
  std::map<double, double> planes_;
};

struct Shifts {
  explicit Shifts(const Room& room) {
    for (const Segment& wall : room.walls) {
      const Vec2 d = wall.direction();
      if (std::abs(d.x) < kSamePlane) x.add(wall.a.x);
      if (std::abs(d.y) < kSamePlane) y.add(wall.a.y);
    }
  }
  void move(Vec2& p) const { p = {x.apply(p.x), y.apply(p.y)}; }
  Shift x;
  Shift y;
};

void apply(const Shifts& shifts, RoomIndex index, Building& plan) {
  Room& room = plan.rooms[static_cast<std::size_t>(index)];
  for (std::vector<Segment>* lines : {&room.walls, &room.reflectors}) {
    for (Segment& line : *lines) {
      shifts.move(line.a);
      shifts.move(line.b);
    }
  }
  for (std::vector<Vec2>* points : {&room.corners, &room.edges}) {
    for (Vec2& point : *points) shifts.move(point);
  }
  for (std::vector<Vec2>& loop : room.boundary) {
    for (Vec2& point : loop) shifts.move(point);
  }
  for (Door& door : plan.doors) {
    if (door.room_a == index) shifts.move(door.at_a);
    if (door.room_b == index) shifts.move(door.at_b);
  }
}

template <class Make>
Building shifted(Building plan, Make make) {
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    Shifts shifts(plan.rooms[i]);
    make(shifts);
    apply(shifts, static_cast<RoomIndex>(i), plan);
  }
  return plan;
}

using Box = std::array<Vec2, 4>;  // Clockwise, as a hole in the floor.

bool fits(const Box& box, const Building& plan, RoomIndex index) {
  constexpr double kDoorClear = 1.2;
  constexpr double kFree = 0.8;  // Around it, but for the wall behind, metres.
  const Room& room = plan.room(index);
  const Vec2 middle = 0.5 * (box[0] + box[2]);
  for (const Vec2 corner : box) {
    if (classify(room.boundary, corner) != Inclusion::inside) return false;
  }
  int near = 0;
  for (const Segment& wall : room.walls) near += distance(wall, middle) < kFree ? 1 : 0;
  const auto too_near = [&](const Segment& line) { return distance(line, middle) < 1.5 * kFree; };
  const auto blocks = [&](const Door& door) {
    return (door.room_a == index && distance(door.at_a, middle) < kDoorClear) ||
           (door.room_b == index && distance(door.at_b, middle) < kDoorClear);
  };
  return near == 1 && std::none_of(room.reflectors.begin(), room.reflectors.end(), too_near) &&
         std::none_of(plan.doors.begin(), plan.doors.end(), blocks);
}

void add_cupboard(Building& plan, RoomIndex index, Random& random) {
  constexpr double kWide = 1.2;
  constexpr double kDeep = 0.6;
  constexpr double kGap = 0.02;  // To the wall behind it.
  Room& room = plan.rooms[static_cast<std::size_t>(index)];
  for (int attempt = 0; attempt < 60; ++attempt) {
    const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(room.walls.size()));
    const Segment wall = room.walls[pick];
    if (wall.length() < kWide + 0.4) continue;
    const Vec2 u = (1.0 / wall.length()) * wall.direction();
    Vec2 inward = perpendicular(u);
    if (!contains(room.boundary, wall.a + 0.5 * wall.direction() + 0.05 * inward)) inward = -inward;
    const Vec2 a = wall.a + random.uniform(0.2, wall.length() - kWide - 0.2) * u + kGap * inward;
    Box box{a, a + kDeep * inward, a + kWide * u + kDeep * inward, a + kWide * u};
    if (!fits(box, plan, index)) continue;
    if (signed_area(box) > 0.0) std::reverse(box.begin(), box.end());
    for (std::size_t i = 0; i < box.size(); ++i) {
      room.walls.push_back({box[i], box[(i + 1) % box.size()]});
      room.edges.push_back(box[i]);
    }
    room.boundary.emplace_back(box.begin(), box.end());
    return;
  }
}

}  // namespace

Building load_plan(std::string_view name) {
  auto plan = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / name);
  if (!plan) throw std::runtime_error(plan.error().to_string());
  return std::move(*plan);
}

Building without_reflectors(Building plan) {
  for (Room& room : plan.rooms) room.reflectors.clear();
  return plan;
}

Building without_corners_and_edges(Building plan) {
  for (Room& room : plan.rooms) {
    room.corners.clear();
    room.edges.clear();
  }
  return plan;
}

Building walls_off(Building plan, double by, std::uint64_t seed) {
  Random random(seed);
  return shifted(std::move(plan), [&](Shifts& shifts) {
    for (Shift* axis : {&shifts.x, &shifts.y}) {
      for (auto& [coordinate, offset] : axis->planes()) offset = random.uniform() < 0.5 ? by : -by;
    }
  });
}

Building partitions_moved(Building plan, double by) {
  return shifted(std::move(plan), [&](Shifts& shifts) {
    const auto reach = [](Shift& axis) { return axis.planes().rbegin()->first - axis.planes().begin()->first; };
    if (shifts.x.planes().empty() || shifts.y.planes().empty()) return;
    (reach(shifts.x) > reach(shifts.y) ? shifts.x : shifts.y).planes().rbegin()->second = by;
  });
}

Building with_cupboards(Building plan, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) add_cupboard(plan, static_cast<RoomIndex>(i), random);
  return plan;
}

sim::World world_of_room(std::string_view id) {
  struct Contents {
    std::string_view room;
    double furniture;  // A square metre.
    double posts;
  };
  // "Moderately to highly cluttered"; room 5's "free floor space almost half of the total"; room 4 answers best of all;
  // the hall's "numerous small features which are not feasible to capture".
  constexpr std::array<Contents, 6> kRooms{{{"1", 0.10, 0.05},
                                            {"3", 0.10, 0.10},
                                            {"4", 0.06, 0.03},
                                            {"5", 0.35, 0.20},
                                            {"6", 0.10, 0.10},
                                            {"hall", 0.02, 0.30}}};
  sim::World world = sim::make_world(sim::Profile::furnished);
  for (const Contents& contents : kRooms) {
    if (contents.room != id) continue;
    world.furniture_per_m2 = contents.furniture;
    world.posts_per_m2 = contents.posts;
  }
  return world;
}

}  // namespace echoway::report
