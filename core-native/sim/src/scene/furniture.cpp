#include "scene/furniture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "echoway/geometry/inclusion.hpp"

namespace echoway::sim {
namespace {

constexpr double kPassage = 0.4;    // Left free beside the wearer's way, metres.
constexpr double kDoorClear = 0.9;  // Left free before a door, metres.
constexpr int kTries = 12;

using Box = std::array<Vec2, 4>;  // A rectangle by its corners, counter-clockwise.

int draw_count(double mean, Random& random) {
  const int whole = static_cast<int>(mean);
  return whole + (random.uniform() < mean - whole ? 1 : 0);
}

class Placer {
 public:
  Placer(const Room& room, const std::vector<Doorway>& doorways, const std::vector<Vec2>& kept_free)
      : room_(room), doorways_(doorways), kept_free_(kept_free) {}

  bool free(const Box& box) const {
    Vec2 middle{};
    for (const Vec2 corner : box) {
      if (!contains(room_.boundary, corner)) return false;
      middle = middle + 0.25 * corner;
    }
    if (!contains(room_.boundary, middle)) return false;
    const double half = distance(middle, box[0]);
    for (const Doorway& doorway : doorways_) {
      if (gap(box, doorway.centre()) < kDoorClear) return false;
    }
    for (const Vec2 place : kept_free_) {
      if (distance(place, middle) < half + kPassage && (gap(box, place) < kPassage || covers(box, place))) return false;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Segment side{box[i], box[(i + 1) % 4]};
      const auto in_the_way = [&](const Segment& other) { return crosses(side, other); };
      if (std::any_of(room_.walls.begin(), room_.walls.end(), in_the_way)) return false;
      if (std::any_of(room_.reflectors.begin(), room_.reflectors.end(), in_the_way)) return false;
    }
    return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return overlap(box, other); });
  }
  void take(const Box& box) { taken_.push_back(box); }

  bool free(Vec2 post) const {
    if (!contains(room_.boundary, post)) return false;
    const auto near = [&](Vec2 place) { return distance(place, post) < kPassage; };
    return std::none_of(kept_free_.begin(), kept_free_.end(), near) &&
           std::none_of(doorways_.begin(), doorways_.end(), [&](const Doorway& d) { return near(d.centre()); });
  }

 private:
  static double gap(const Box& box, Vec2 p) {
    double d = distance(Segment{box[3], box[0]}, p);
    for (std::size_t i = 0; i < 3; ++i) d = std::min(d, distance(Segment{box[i], box[i + 1]}, p));
    return d;
  }
  static bool covers(const Box& box, Vec2 p) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (cross(box[(i + 1) % 4] - box[i], p - box[i]) < 0.0) return false;
    }
    return true;
  }
  static bool overlap(const Box& a, const Box& b) {
    if (covers(a, b[0]) || covers(b, a[0])) return true;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        if (crosses({a[i], a[(i + 1) % 4]}, {b[j], b[(j + 1) % 4]})) return true;
      }
    }
    return false;
  }
  static bool crosses(const Segment& a, const Segment& b) {
    const auto side = [](const Segment& s, Vec2 p) { return cross(s.direction(), p - s.a) > 0.0; };
    return side(a, b.a) != side(a, b.b) && side(b, a.a) != side(b, a.b);
  }

  const Room& room_;
  const std::vector<Doorway>& doorways_;
  const std::vector<Vec2>& kept_free_;
  std::vector<Box> taken_;
};

Box rectangle(Vec2 origin, Vec2 u, double width, double depth) {
  const Vec2 v = perpendicular(u);
  return {origin, origin + width * u, origin + width * u + depth * v, origin + depth * v};
}

// A place up to 3 m from a wall's. One draw a statement: the order within an expression is the compiler's choice.
Vec2 draw_beside(const Segment& wall, double nearest, Random& random) {
  const Vec2 towards = unit_from_angle(random.uniform(0.0, kTwoPi));
  const double off = random.uniform(nearest, 3.0);
  const double along = random.uniform();
  return wall.a + along * wall.direction() + off * towards;
}

// Most furniture stands with its back to a wall; some stands free and askew.
Box draw_box(const Room& room, Random& random) {
  const double width = random.uniform(0.4, 1.6);
  const double depth = random.uniform(0.3, 0.7);
  const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(room.walls.size()));
  const Segment& wall = room.walls[std::min(pick, room.walls.size() - 1)];
  const double length = std::max(1e-6, wall.length());
  const double along = random.uniform() * std::max(0.0, length - width);
  const double off = random.uniform(0.005, 0.05);
  if (random.uniform() < 0.75) {
    Vec2 u = (1.0 / length) * wall.direction();
    Vec2 origin = wall.a + along * u;
    if (!contains(room.boundary, origin + 0.5 * width * u + 0.1 * perpendicular(u))) {
      origin = origin + width * u;
      u = -u;
    }
    return rectangle(origin + off * perpendicular(u), u, width, depth);
  }
  const Vec2 u = unit_from_angle(random.uniform(0.0, kTwoPi));
  return rectangle(draw_beside(wall, 0.5, random), u, width, depth);
}

}  // namespace

void add_furniture(const Room& room, const std::vector<Doorway>& doorways, const World& world,
                   const std::vector<Vec2>& kept_free, Random& random, RoomScene& scene) {
  if (room.walls.empty()) return;
  Placer placer(room, doorways, kept_free);
  const double area = floor_area(room);
  for (int left = draw_count(world.furniture_per_m2 * area, random); left > 0; --left) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Box box = draw_box(room, random);
      if (!placer.free(box)) continue;
      placer.take(box);
      const double reflectivity = random.uniform(0.5, 0.95);
      for (std::size_t i = 0; i < 4; ++i) {
        scene.panels.push_back({{box[i], box[(i + 1) % 4]}, reflectivity});
        scene.things.push_back(scene.panels.back().at);
      }
      break;
    }
  }
  for (int left = draw_count(world.posts_per_m2 * area, random); left > 0; --left) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Segment& wall =
          room.walls[static_cast<std::size_t>(random.uniform() * static_cast<double>(room.walls.size()))];
      const Vec2 at = draw_beside(wall, 0.1, random);
      if (!placer.free(at)) continue;
      scene.scatterers.push_back({at, random.uniform(0.01, 0.05), 1.0});
      scene.things.push_back({at, at});
      break;
    }
  }
}

}  // namespace echoway::sim
