#include "scene/room_scene.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/building/opening.hpp"
#include "scene/furniture.hpp"

namespace echoway::sim {
namespace {

constexpr double kShortest = 0.01;    // Shorter pieces of wall are dropped, metres.
constexpr double kJoint = 0.03;       // Panels meet when they come this close, metres.
constexpr double kCasingWall = 0.3;   // Wall beside a casing that serves its corner, metres.
constexpr double kRightAngle = 0.05;  // Cosine of the angle up to which a joint still returns sound.

// The sides of a passage through a wall that is drawn with its thickness: this room's half of them.
void add_reveals(const Doorway& doorway, double reflectivity, RoomScene& scene) {
  const Vec2 outward = doorway.middle() - doorway.centre();
  if (norm(outward) < kShortest || dot(outward, doorway.inward) > 0.0) return;
  for (const Vec2 jamb : {doorway.opening.a, doorway.opening.b})
    scene.panels.push_back({{jamb, jamb + outward}, reflectivity});
}

// A casing is nailed around the frame and stands out from the wall: with the wall it makes a shallow corner.
void add_casings(const Doorway& doorway, double reflectivity, Random& random, RoomScene& scene) {
  const double wide = random.uniform(0.05, 0.10);
  const double proud = random.uniform(0.01, 0.03);
  for (const double side : {-1.0, 1.0}) {
    const Vec2 away = side * doorway.along();
    const Vec2 at = (side < 0.0 ? doorway.opening.a : doorway.opening.b) + wide * away;
    scene.corners.push_back({at, away, doorway.inward, kCasingWall, proud, reflectivity * reflectivity});
  }
}

void add_corners_of(const Panel& one, const Panel& two, std::vector<Corner>& corners) {
  const double length_1 = one.at.length();
  const double length_2 = two.at.length();
  const Vec2 u = (1.0 / length_1) * one.at.direction();
  const Vec2 v = (1.0 / length_2) * two.at.direction();
  if (std::abs(dot(u, v)) > kRightAngle) return;
  const double s = cross(two.at.a - one.at.a, v) / cross(u, v);
  const Vec2 at = one.at.a + s * u;
  const double t = dot(at - two.at.a, v);
  if (s < -kJoint || s > length_1 + kJoint || t < -kJoint || t > length_2 + kJoint) return;
  for (const double sign_u : {-1.0, 1.0}) {
    for (const double sign_v : {-1.0, 1.0}) {
      const double reach_u = sign_u > 0.0 ? length_1 - s : s;
      const double reach_v = sign_v > 0.0 ? length_2 - t : t;
      if (reach_u <= kJoint || reach_v <= kJoint) continue;
      corners.push_back({at, sign_u * u, sign_v * v, reach_u, reach_v, one.reflectivity * two.reflectivity});
    }
  }
}

void add_edges(const World& world, RoomScene& scene) {
  const double gain = std::pow(10.0, world.edge_gain_db / 20.0);
  std::vector<Vec2> seen;
  for (const Panel& panel : scene.panels) {
    for (const Vec2 end : {panel.at.a, panel.at.b}) {
      const bool known =
          std::any_of(seen.begin(), seen.end(), [&](Vec2 other) { return distance(other, end) < kJoint; });
      if (known) continue;
      seen.push_back(end);
      scene.scatterers.push_back({end, 0.0, gain});
    }
  }
}

// A wall of brick, books or curtains: many small things at its face, each of its own strength.
void add_roughness(const Segment& wall, Random& random, RoomScene& scene) {
  const double length = wall.length();
  const double gain = std::pow(10.0, random.uniform(0.0, 10.0) / 20.0);
  for (double at = random.uniform(0.0, 0.2); at < length; at += random.uniform(0.05, 0.35)) {
    const Vec2 face = wall.a + (at / length) * wall.direction();
    scene.scatterers.push_back({face, random.uniform(0.002, 0.015), gain});
  }
}

// Equipment on a bench sends sound back at any incidence (thesis section 6.2.1): small things along it.
void add_bench(const Segment& bench, Random& random, RoomScene& scene) {
  const double length = bench.length();
  double at = random.uniform(0.0, 0.15);
  while (at < length) {
    scene.scatterers.push_back({bench.a + (at / length) * bench.direction(), random.uniform(0.02, 0.10), 1.0});
    at += random.uniform(0.08, 0.35);
  }
  scene.panels.push_back({bench, 0.5});
}

}  // namespace

void finish_scene(const World& world, RoomScene& scene) {
  for (std::size_t i = 0; i < scene.panels.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.panels.size(); ++j) {
      add_corners_of(scene.panels[i], scene.panels[j], scene.corners);
    }
  }
  add_edges(world, scene);
}

RoomScene build_room_scene(const Room& room, const std::vector<Doorway>& doorways, const World& world,
                           const std::vector<Vec2>& kept_free, Random random) {
  RoomScene scene;
  Random of_walls = random.split();
  Random of_doors = random.split();
  Random of_benches = random.split();
  Random of_furniture = random.split();
  std::vector<DoorOpening> openings;
  for (const Doorway& doorway : doorways) openings.push_back({doorway.door, doorway.other, 0, doorway.opening});
  for (const Segment& piece : walls_with_doors_open(room, openings)) {
    if (piece.length() < kShortest) continue;
    const double reflectivity = std::clamp(world.reflectivity + of_walls.normal(0.0, 0.05), 0.2, 1.0);
    const bool rough = of_walls.uniform() < world.rough_walls;
    scene.panels.push_back({piece, rough ? 0.6 * reflectivity : reflectivity});
    if (rough) add_roughness(piece, of_walls, scene);
  }
  for (const Doorway& doorway : doorways) {
    add_reveals(doorway, world.reflectivity, scene);
    if (of_doors.uniform() < world.door_casings) add_casings(doorway, world.reflectivity, of_doors, scene);
  }
  add_furniture(room, doorways, world, kept_free, of_furniture, scene);
  for (const Segment& bench : room.reflectors) add_bench(bench, of_benches, scene);
  finish_scene(world, scene);
  return scene;
}

}  // namespace echoway::sim
