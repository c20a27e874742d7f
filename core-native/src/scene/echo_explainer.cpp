#include "echoway/scene/echo_explainer.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/room_scene.hpp"
#include "scene/visibility.hpp"

namespace echoway {
namespace {

using scene::Reflector;
using scene::ReflectorKind;
using scene::RoomScene;

constexpr double kCellSize = 0.5;                 // Of a grid that is not looked at here.
constexpr double kBeamSlack = degrees(4.0);       // Walls answer a little beyond the nominal beam.
constexpr double kMostTurn = degrees(15.0);       // However little is known of the heading.
constexpr double kMostShift = 0.5;                // Metres, however little is known of the position.
constexpr double kFloor = 0.05;                   // Metres: plans are drawn to about this.
constexpr double kNearest = 1e-6;

/// One sensor's ray, and how loosely it is to be taken.
struct Ray {
  Vec2 eye{};
  Vec2 axis{};
  double cosine = 1.0;  // of half the beam
};

/// Where an echo turns back, and the range it gives.
struct Turn {
  bool present = false;
  Vec2 at{};
  Vec2 via{};           // a mirrored corner: where the sound meets the wall
  double range = 0.0;
};

bool in_beam(const Ray& ray, Vec2 way, double length) noexcept {
  return length > kNearest && dot(ray.axis, way) >= ray.cosine * length;
}

Turn from_wall(const Reflector& r, const Ray& ray) noexcept {
  const double side = r.signed_distance(ray.eye);
  const double t = r.along(ray.eye);
  if ((side < 0.0 && !r.two_sided) || t < -scene::kWallEndSoftness || t > r.length + scene::kWallEndSoftness) return {};
  const Vec2 foot = ray.eye - side * r.normal;
  return {in_beam(ray, foot - ray.eye, std::abs(side)), foot, {}, std::abs(side)};
}

Turn from_point(Vec2 at, const Ray& ray) noexcept {
  const double away = distance(at, ray.eye);
  return {in_beam(ray, at - ray.eye, away), at, {}, away};
}

/// Its nearest point if that is in the beam, else where the beam's sides meet it.
Turn from_all_reflective(const Reflector& r, const Ray& ray) noexcept {
  if (const Turn nearest = from_point(nearest_point({r.a, r.b}, ray.eye), ray); nearest.present) return nearest;
  Turn best;
  const double sine = std::sqrt(std::max(0.0, 1.0 - ray.cosine * ray.cosine));
  for (const double s : {sine, -sine}) {
    const Vec2 side = rotated(ray.axis, {ray.cosine, s});
    const double approach = -dot(r.normal, side);
    if (std::abs(approach) < 0.1) continue;  // grazing
    const double range = r.signed_distance(ray.eye) / approach;
    const Vec2 at = ray.eye + range * side;
    const double t = r.along(at);
    if (range > kNearest && t >= 0.0 && t <= r.length && (!best.present || range < best.range)) {
      best = {true, at, {}, range};
    }
  }
  return best;
}

/// A corner's image behind a wall, seen through the wall as through a window.
Turn from_mirrored(const RoomScene& room, const Reflector& r, const Ray& ray) noexcept {
  Turn turn = from_point(r.a, ray);
  const Reflector& wall = room.reflectors[static_cast<std::size_t>(r.mirror)];
  const double before = wall.signed_distance(ray.eye);
  const double behind = wall.signed_distance(r.a);
  if (!turn.present || !(before * behind < 0.0)) return {};
  turn.via = ray.eye + before / (before - behind) * (r.a - ray.eye);
  const double t = wall.along(turn.via);
  turn.at = r.b;
  turn.present = t > 0.0 && t < wall.length;
  return turn;
}

Turn turn_of(const RoomScene& room, const Reflector& r, const Ray& ray) noexcept {
  switch (r.kind) {
    case ReflectorKind::wall:
      return from_wall(r, ray);
    case ReflectorKind::corner:
    case ReflectorKind::edge:
      return from_point(r.a, ray);
    case ReflectorKind::all_reflective:
      return from_all_reflective(r, ray);
    case ReflectorKind::mirrored_corner:
      return from_mirrored(room, r, ray);
  }
  return {};
}

ElementKind element_of(ReflectorKind kind) noexcept {
  switch (kind) {
    case ReflectorKind::wall:
      return ElementKind::wall;
    case ReflectorKind::corner:
    case ReflectorKind::mirrored_corner:
      return ElementKind::corner;
    case ReflectorKind::edge:
      return ElementKind::edge;
    case ReflectorKind::all_reflective:
      return ElementKind::reflector;
  }
  return ElementKind::none;
}

bool hidden(const RoomScene& room, Vec2 from, Vec2 to) noexcept {
  const Vec2 end = scene::in_front_of(to, from, distance(from, to));
  return std::any_of(room.occluders.begin(), room.occluders.end(),
                     [&](const Segment& s) { return scene::blocks(s, from, end); });
}

/// Beyond a door through which the way does not lead.
bool beside_its_door(const RoomScene& room, const Reflector& r, Vec2 eye, Vec2 at) noexcept {
  if (r.opening < 0) return false;
  const scene::Opening& door = room.openings[static_cast<std::size_t>(r.opening)];
  return !scene::blocks(door.span(), eye, at) && distance(eye, door.centre) >= scene::kInDoorway;
}

bool can_be_seen(const RoomScene& room, const Reflector& r, const Ray& ray, const Turn& turn) noexcept {
  if (r.kind == ReflectorKind::mirrored_corner) {
    const Vec2 bounce = scene::in_front_of(turn.via, ray.eye, distance(turn.via, ray.eye));
    return !hidden(room, ray.eye, turn.via) && !hidden(room, bounce, turn.at);
  }
  return !beside_its_door(room, r, ray.eye, turn.at) && !hidden(room, ray.eye, turn.at);
}

double at_most(double value, double most) noexcept {
  return std::isfinite(value) ? std::clamp(value, 0.0, most) : most;
}

}  // namespace

struct EchoExplainer::Impl {
  BeltConfig belt;
  std::vector<RoomScene> rooms;
};

EchoExplainer::EchoExplainer(const Building& building, const BeltConfig& belt)
    : impl_(std::make_unique<Impl>(Impl{belt, {}})) {
  const scene::RoomCompiler compiler(building, belt.max_range_m, kCellSize);
  impl_->rooms.reserve(compiler.rooms());
  for (std::size_t i = 0; i < compiler.rooms(); ++i) {
    impl_->rooms.push_back(compiler.compile(static_cast<RoomIndex>(i)));
  }
}
EchoExplainer::~EchoExplainer() = default;

ExplainedEcho EchoExplainer::explain(const Firing& firing, const Estimate& estimate) const noexcept {
  ExplainedEcho echo{.firing = firing};
  const bool placed = estimate.room >= 0 && static_cast<std::size_t>(estimate.room) < impl_->rooms.size() &&
                      is_finite(estimate.pose);
  if (!placed) return echo;
  echo.room = estimate.room;
  const BeltConfig& belt = impl_->belt;
  if (firing.sensor < 0 || firing.sensor >= belt.sensors || !firing.has_echo() || !std::isfinite(firing.range_m)) {
    return echo;
  }

  const RoomScene& room = impl_->rooms[static_cast<std::size_t>(estimate.room)];
  const Vec2 axis = unit_from_angle(estimate.pose.heading + belt.bearing(firing.sensor));
  const double half = 0.5 * belt.beam_rad + kBeamSlack + at_most(estimate.sigma_heading_rad, kMostTurn);
  const Ray ray{estimate.pose.position + belt.radius_m * axis, axis, std::cos(std::min(half, degrees(85.0)))};
  const double blur = hypotenuse(belt.range_noise * firing.range_m, at_most(estimate.sigma_m, kMostShift));
  const double tolerance = kFloor + 2.0 * blur;
  for (const Reflector& r : room.reflectors) {
    const Turn turn = turn_of(room, r, ray);
    const bool nearer = echo.kind == ElementKind::none || turn.range < echo.expected_m;
    if (!turn.present || !nearer || std::abs(turn.range - firing.range_m) > tolerance) continue;
    if (!can_be_seen(room, r, ray, turn)) continue;
    echo.kind = element_of(r.kind);
    echo.at = turn.at;
    echo.expected_m = turn.range;
  }
  return echo;
}

}  // namespace echoway
