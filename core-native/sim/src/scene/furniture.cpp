#include "scene/furniture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echoway::sim {
namespace {

constexpr double kPassage = 0.4;      // Left free beside the wearer's way, metres.
constexpr double kDoorClear = 0.9;    // Left free before a door, metres.
constexpr int kTries = 12;

int draw_count(double mean, Random& random) {
  const int whole = static_cast<int>(mean);
  return whole + (random.uniform() < mean - whole ? 1 : 0);
}

class Placer {
 public:
  Placer(const Room& room, const std::vector<Doorway>& doorways, const std::vector<Vec2>& kept_free)
      : room_(room), doorways_(doorways), kept_free_(kept_free) {}

  // A rectangle by its corners in order.
  bool free(const std::array<Vec2, 4>& box) const {
    Vec2 middle{};
    for (const Vec2 corner : box) {
      if (!inside(room_, corner)) return false;
      middle = middle + 0.25 * corner;
    }
    if (!inside(room_, middle)) return false;
    const double half = distance(middle, box[0]);
    for (const Doorway& doorway : doorways_) {
      if (gap(box, doorway.centre) < kDoorClear) return false;
    }
    for (const Vec2 place : kept_free_) {
      if (distance(place, middle) < half + kPassage && (gap(box, place) < kPassage || contains(box, place))) return false;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (const Segment& wall : room_.walls) {
        if (crosses({box[i], box[(i + 1) % 4]}, wall)) return false;
      }
    }
    return true;
  }
  bool free(Vec2 post) const {
    if (!inside(room_, post)) return false;
    const auto near = [&](Vec2 place) { return distance(place, post) < kPassage; };
    return std::none_of(kept_free_.begin(), kept_free_.end(), near) &&
           std::none_of(doorways_.begin(), doorways_.end(), [&](const Doorway& d) { return near(d.centre); });
  }

 private:
  static double gap(const std::array<Vec2, 4>& box, Vec2 p) {
    double d = distance(Segment{box[3], box[0]}, p);
    for (std::size_t i = 0; i < 3; ++i) d = std::min(d, distance(Segment{box[i], box[i + 1]}, p));
    return d;
  }
  static bool contains(const std::array<Vec2, 4>& box, Vec2 p) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (cross(box[(i + 1) % 4] - box[i], p - box[i]) < 0.0) return false;
    }
    return true;
  }
  static bool crosses(const Segment& a, const Segment& b) {
    const auto side = [](const Segment& s, Vec2 p) { return cross(s.direction(), p - s.a) > 0.0; };
    return side(a, b.a) != side(a, b.b) && side(b, a.a) != side(b, a.b);
  }

  const Room& room_;
  const std::vector<Doorway>& doorways_;
  const std::vector<Vec2>& kept_free_;
};

std::array<Vec2, 4> rectangle(Vec2 origin, Vec2 u, double width, double depth) {
  const Vec2 v = perpendicular(u);
  return {origin, origin + width * u, origin + width * u + depth * v, origin + depth * v};
}

// Most furniture stands with its back to a wall; some stands free and askew.
std::array<Vec2, 4> draw_box(const Room& room, Random& random) {
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
    if (!inside(room, origin + 0.5 * width * u + 0.1 * perpendicular(u))) {
      origin = origin + width * u;
      u = -u;
    }
    return rectangle(origin + off * perpendicular(u), u, width, depth);
  }
  const Vec2 u = unit_from_angle(random.uniform(0.0, kTwoPi));
  const Vec2 at = wall.a + random.uniform() * wall.direction() + random.uniform(0.5, 3.0) * unit_from_angle(random.uniform(0.0, kTwoPi));
  return rectangle(at, u, width, depth);
}

}  // namespace

void add_furniture(const Room& room, const std::vector<Doorway>& doorways, const World& world,
                   const std::vector<Vec2>& kept_free, Random& random, RoomScene& scene) {
  if (room.walls.empty()) return;
  const Placer placer(room, doorways, kept_free);
  const double area = floor_area(room);
  for (int left = draw_count(world.furniture_per_m2 * area, random); left > 0; --left) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const std::array<Vec2, 4> box = draw_box(room, random);
      if (!placer.free(box)) continue;
      const double reflectivity = random.uniform(0.5, 0.95);
      for (std::size_t i = 0; i < 4; ++i) scene.panels.push_back({{box[i], box[(i + 1) % 4]}, reflectivity});
      break;
    }
  }
  for (int left = draw_count(world.posts_per_m2 * area, random); left > 0; --left) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Segment& wall = room.walls[static_cast<std::size_t>(random.uniform() * static_cast<double>(room.walls.size()))];
      const Vec2 at = wall.a + random.uniform() * wall.direction() + random.uniform(0.1, 3.0) * unit_from_angle(random.uniform(0.0, kTwoPi));
      if (!placer.free(at)) continue;
      scene.scatterers.push_back({at, random.uniform(0.01, 0.05), 1.0});
      break;
    }
  }
}

}  // namespace echoway::sim
