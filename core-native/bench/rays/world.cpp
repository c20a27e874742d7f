#include "rays/world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "echoway/belt/belt.hpp"

namespace echoway::rays {
namespace {

constexpr double kFarthest = 10.5;          // Metres that anything answers from,
constexpr double kHalfHeard = 9.0;          // half as often at this distance.
constexpr double kLeastChance = 0.02;

constexpr double kPlane = 0.96;
constexpr double kCorner = 0.93;
constexpr double kEdge = 0.45;
constexpr double kBench = 0.7;
constexpr double kPost = 0.5;
constexpr double kPerson = 0.6;

double logistic(double x) noexcept { return 1.0 / (1.0 + std::exp(-x)); }

Vec2 mirrored(Vec2 p, const Segment& in) noexcept {
  const Vec2 normal = (1.0 / in.length()) * perpendicular(in.direction());
  return p - 2.0 * dot(p - in.a, normal) * normal;
}

// The foot of `p` on the line of `s`, if it lies within the segment.
std::optional<Vec2> foot_on(const Segment& s, Vec2 p) noexcept {
  const double t = dot(p - s.a, s.direction()) / squared_norm(s.direction());
  return t > 0.0 && t < 1.0 ? std::optional(s.a + t * s.direction()) : std::nullopt;
}

}  // namespace

World::World(Things things, Random random)
    : things_(std::move(things)),
      random_(random),
      beam_(random_.uniform(degrees(7.5), degrees(11.0))),
      beam_softness_(random_.uniform(degrees(0.5), degrees(2.0))),
      unheard_(random_.uniform(0.03, 0.12)),
      ghost_(random_.uniform(0.005, 0.03)),
      arm_(random_.uniform(0.0, 0.04)),
      scale_(random_.uniform(-0.02, 0.02)),
      edge_reach_(random_.uniform(1.0, 2.5)),
      second_order_(random_.uniform(0.2, 0.7)) {
  for (std::size_t i = 0; i < things_.people.size(); ++i) {
    velocities_.push_back(random_.uniform(0.0, 0.8) * unit_from_angle(random_.uniform(-kPi, kPi)));
  }
}

double World::fire(Vec2 eye, Vec2 axis, double seconds) {
  move_people(seconds);
  answers_.clear();
  ask_planes(eye, axis);
  ask_points(eye, axis);
  ask_benches(eye, axis);
  ask_discs(eye, axis, things_.posts, kPost);
  ask_discs(eye, axis, things_.people, kPerson);
  ask_by_way_of_walls(eye, axis);
  double range = random_.uniform() < unheard_ ? Firing::kNoEcho : nearest_that_answers();
  if (random_.uniform() < arm_) range = random_.uniform(0.16, 0.4);
  return random_.uniform() < ghost_ ? random_.uniform(0.2, 10.0) : range;
}

double World::nearest_that_answers() {
  constexpr double kNoise = 0.01, kNoiseFloor = 0.004;
  std::ranges::sort(answers_, {}, &Answer::range);
  for (const Answer& a : answers_) {
    if (random_.uniform() >= a.chance) continue;
    return a.range * (1.0 + scale_ + random_.normal(0.0, kNoise)) + random_.normal(0.0, kNoiseFloor);
  }
  return Firing::kNoEcho;
}

void World::move_people(double seconds) {
  for (std::size_t i = 0; i < things_.people.size(); ++i) {
    things_.people[i].centre = things_.people[i].centre + seconds * velocities_[i];
    if (random_.uniform() < 0.02) velocities_[i] = -velocities_[i];
  }
}

double World::beam(Vec2 axis, Vec2 way) const noexcept {
  const double off = std::atan2(std::abs(cross(axis, way)), dot(axis, way));
  return logistic((beam_ - off) / beam_softness_);
}

void World::add(double range, double chance) {
  if (!(range < kFarthest && chance > kLeastChance)) return;
  answers_.push_back({range, chance * logistic((kHalfHeard - range) / 0.8)});
}

void World::ask_planes(Vec2 eye, Vec2 axis) {
  for (const Segment& plane : things_.planes) {
    const std::optional<Vec2> foot = foot_on(plane, eye);
    if (!foot) continue;
    const double chance = kPlane * beam(axis, *foot - eye);
    if (chance > kLeastChance && things_.in_sight(eye, *foot)) add(distance(eye, *foot), chance);
  }
}

void World::ask_points(Vec2 eye, Vec2 axis) {
  const auto ask = [&](Vec2 point, double chance) {
    chance *= beam(axis, point - eye);
    if (chance > kLeastChance && things_.in_sight(eye, point)) add(distance(eye, point), chance);
  };
  for (const Vec2 corner : things_.corners) ask(corner, kCorner);
  for (const Vec2 edge : things_.edges) {
    if (distance(edge, eye) < edge_reach_) ask(edge, kEdge);
  }
}

// The nearest point of each that lies in the beam and in sight.
void World::ask_benches(Vec2 eye, Vec2 axis) {
  constexpr int kPoints = 40;
  for (const Segment& bench : things_.benches) {
    double nearest = kFarthest;
    for (int i = 0; i <= kPoints; ++i) {
      const Vec2 point = bench.a + static_cast<double>(i) / kPoints * bench.direction();
      const double range = distance(eye, point);
      if (range < nearest && beam(axis, point - eye) > 0.5 && things_.in_sight(eye, point)) nearest = range;
    }
    add(nearest, kBench);
  }
}

void World::ask_discs(Vec2 eye, Vec2 axis, const std::vector<Disc>& discs, double chance) {
  constexpr double kReach = 4.0;
  for (const Disc& disc : discs) {
    const double range = distance(eye, disc.centre) - disc.radius;
    if (range < 0.05 || range > kReach) continue;
    const double in_beam = chance * beam(axis, disc.centre - eye);
    if (in_beam > kLeastChance && things_.in_sight(eye, disc.centre)) add(range, in_beam);
  }
}

// Sound that meets a wall aslant, then another one squarely, and comes back the same way: as if from the mirror image.
void World::ask_by_way_of_walls(Vec2 eye, Vec2 axis) {
  for (std::size_t m = 0; m < things_.walls; ++m) {
    const Segment& mirror = things_.planes[m];
    if (distance(mirror, eye) > 6.0 || mirror.length() < 0.1) continue;
    const Vec2 image = mirrored(eye, mirror);
    for (std::size_t w = 0; w < things_.walls; ++w) {
      const std::optional<Vec2> foot = w != m ? foot_on(things_.planes[w], image) : std::nullopt;
      const std::optional<Vec2> via = foot ? crossing(mirror, image, *foot) : std::nullopt;
      if (!via) continue;
      const double chance = second_order_ * beam(axis, *via - eye);
      if (chance > kLeastChance && things_.in_sight(eye, *via) && things_.in_sight(*via, *foot)) {
        add(distance(image, *foot), chance);
      }
    }
  }
}

}  // namespace echoway::rays
