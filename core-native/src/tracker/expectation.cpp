#include <algorithm>
#include <cmath>

#include "scene/visibility.hpp"
#include "tracker/elementary.hpp"
#include "tracker/likelihood.hpp"

namespace echoway::tracker {
namespace {

using scene::Cell;
using scene::Reflector;
using scene::ReflectorKind;
using scene::RoomScene;

// A wall's mirror spot needs about half a Fresnel zone of wall (sqrt(lambda z) / 2, 7 cm at 3 m); near a wall's end the
// echo fades over this much.
constexpr double kWallEndSoftness = 0.07;
constexpr double kCoarseWallEndSoftness = 0.20;
constexpr double kBeamEdgeSpread = 0.035;   // Radians by which the beam's edge is uncertain.
constexpr double kRoughSpread = 0.06;       // Radians within the beam from which a rough wall's echo comes;
constexpr double kCoarseRoughSpread = 0.10; // the same of particles that stand for cells of headings.
constexpr double kOffTheBeam = 0.02;        // A wall that answers less often squarely is heard by its roughness, if at all.
constexpr double kNearest = 1e-6;

struct View {
  Vec2 eye;         // The transducer.
  Vec2 axis;        // Its direction.
  bool coarse;
  const EchoModel& model;
};

// A rough wall answers from where the axis meets it, give or take what the beam's width blurs.
bool see_rough_wall(const Reflector& r, const View& view, double d, Vec2 normal, ExpectedEcho& echo, Vec2& target) noexcept {
  const double cosine = -dot(view.axis, normal);
  const double way = d / std::max(cosine, 0.01);
  echo.chance = view.model.rough(cosine, way);
  if (echo.chance <= 0.0) return false;
  target = view.eye + way * view.axis;
  const double t = r.along(target);
  if (t < 0.0 || t > r.length) return false;
  echo.range = way;
  echo.gradient = (1.0 / cosine) * normal;
  const double blur = way * std::abs(cross(view.axis, normal)) / cosine * (view.coarse ? kCoarseRoughSpread : kRoughSpread);
  echo.extra_variance = blur * blur;
  return true;
}

bool see_wall(const Reflector& r, const View& view, ExpectedEcho& echo, Vec2& target) noexcept {
  double d = r.signed_distance(view.eye);
  Vec2 normal = r.normal;
  if (d < 0.0 && r.two_sided) {
    d = -d;
    normal = -normal;
  }
  if (!(d > kNearest) || !(dot(view.axis, normal) < 0.0)) return false;
  const double beam = view.model.beam(std::abs(cross(view.axis, normal)), view.coarse);
  if (beam <= kOffTheBeam) return see_rough_wall(r, view, d, normal, echo, target);
  const double soft = view.coarse ? kCoarseWallEndSoftness : kWallEndSoftness;
  const double t = r.along(view.eye);
  const double inside = std::min(t, r.length - t);
  if (inside <= -soft) return false;
  echo.chance = beam * view.model.reach(ReflectorKind::wall, d);
  if (inside < soft) echo.chance *= 0.5 * (1.0 + inside / soft);
  echo.range = d;
  echo.gradient = normal;
  target = view.eye - d * normal;
  return true;
}

bool see_point(const Reflector& r, const View& view, ExpectedEcho& echo, Vec2& target) noexcept {
  const Vec2 way = r.a - view.eye;
  const double d2 = squared_norm(way);
  if (!(d2 > kNearest * kNearest) || !(dot(view.axis, way) > 0.0)) return false;
  const double d = std::sqrt(d2);
  const Vec2 direction = (1.0 / d) * way;
  const double beam = view.model.beam(std::abs(cross(view.axis, direction)), view.coarse);
  if (beam <= 0.0) return false;
  echo.chance = beam * view.model.reach(r.kind, d);
  echo.range = d;
  echo.gradient = -direction;
  target = r.a;
  return true;
}

// The nearest point of the element inside the beam: its nearest point if that is inside, else where the beam's edge
// meets it.
bool see_all_reflective(const Reflector& r, const View& view, ExpectedEcho& echo, Vec2& target) noexcept {
  const Vec2 nearest = nearest_point({r.a, r.b}, view.eye);
  const Vec2 way = nearest - view.eye;
  const double d = std::sqrt(squared_norm(way));
  const double cosine = view.model.half_beam_cosine();
  if (d > kNearest && dot(view.axis, way) >= cosine * d) {
    echo.range = d;
    echo.gradient = (-1.0 / d) * way;
    target = nearest;
  } else {
    double best = 1e300;
    for (const double sine : {view.model.half_beam_sine(), -view.model.half_beam_sine()}) {
      const Vec2 ray{cosine * view.axis.x - sine * view.axis.y, sine * view.axis.x + cosine * view.axis.y};
      const double approach = -dot(r.normal, ray);
      if (std::abs(approach) < 0.1) continue;
      const double way_along = r.signed_distance(view.eye) / approach;
      const Vec2 hit = view.eye + way_along * ray;
      const double t = r.along(hit);
      if (!(way_along > kNearest) || way_along >= best || t < 0.0 || t > r.length) continue;
      best = way_along;
      echo.range = way_along;
      echo.gradient = (1.0 / approach) * r.normal;
      const double slope = way_along * std::abs(dot(r.tangent, ray)) / std::abs(approach) * kBeamEdgeSpread;
      echo.extra_variance = slope * slope;
      target = hit;
    }
    if (best == 1e300) return false;
  }
  echo.chance = view.model.reach(ReflectorKind::all_reflective, echo.range);
  return true;
}

// A corner's image behind a wall, seen through the wall as through a window; `via` is where the sound meets the wall.
bool see_mirrored(const RoomScene& room, const Reflector& r, const View& view, ExpectedEcho& echo, Vec2& via) noexcept {
  if (!see_point(r, view, echo, via)) return false;
  const Reflector& wall = room.reflectors[static_cast<std::size_t>(r.mirror)];
  const double before = wall.signed_distance(view.eye);
  const double behind = wall.signed_distance(r.a);
  if (!(before * behind < 0.0)) return false;
  via = view.eye + before / (before - behind) * (r.a - view.eye);
  const double t = wall.along(via);
  return t > 0.0 && t < wall.length;
}

bool hidden(const RoomScene& room, const Cell& cell, const Cell::Entry& entry, Vec2 eye, Vec2 target, double way) noexcept {
  if (entry.occluder_count == 0) return false;
  const Vec2 end = scene::in_front_of(target, eye, way);
  for (unsigned k = 0; k < entry.occluder_count; ++k) {
    if (scene::blocks(room.occluders[cell.occluders[entry.occluder_begin + k]], eye, end)) return true;
  }
  return false;
}

// True when `r` lies beyond a door through which the way to `target` does not lead.
bool beside_its_door(const RoomScene& room, const Reflector& r, Vec2 eye, Vec2 target) noexcept {
  if (r.opening < 0) return false;
  const scene::Opening& door = room.openings[static_cast<std::size_t>(r.opening)];
  return !scene::blocks(door.span(), eye, target) && squared_norm(eye - door.centre) >= scene::kInDoorway * scene::kInDoorway;
}

void insert_sorted(ExpectedEchoes& list, const ExpectedEcho& echo) noexcept {
  int at = std::min(list.count, ExpectedEchoes::kMax);
  if (at == ExpectedEchoes::kMax) {
    if (echo.range >= list.echo[ExpectedEchoes::kMax - 1].range) return;
    --at;
  } else {
    ++list.count;
  }
  while (at > 0 && list.echo[static_cast<std::size_t>(at - 1)].range > echo.range) {
    list.echo[static_cast<std::size_t>(at)] = list.echo[static_cast<std::size_t>(at - 1)];
    --at;
  }
  list.echo[static_cast<std::size_t>(at)] = echo;
}

Vec2 axis_of(const Particle& p, const Shot& shot) noexcept {
  return {p.facing.x * shot.bearing.x - p.facing.y * shot.bearing.y, p.facing.y * shot.bearing.x + p.facing.x * shot.bearing.y};
}

}  // namespace

ExpectedEchoes expect(const Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  const Vec2 eye = p.position + shot.radius * axis_of(p, shot);
  return expect_from(scene.cell_at(p.room, eye), scene.room(p.room), p, shot, model);
}

ExpectedEchoes expect_from(const Cell& cell, const RoomScene& room, const Particle& p, const Shot& shot,
                           const EchoModel& model) noexcept {
  const Vec2 axis = axis_of(p, shot);
  const View view{p.position + shot.radius * axis, axis, shot.coarse, model};
  const double turns = (p.heading + shot.bearing_rad) * (1.0 / kTwoPi);
  const double part = turns - std::floor(turns);
  const auto sector = std::min(static_cast<std::size_t>(part * Cell::kSectors), std::size_t{Cell::kSectors - 1});

  ExpectedEchoes list;
  for (unsigned i = cell.sector_begin[sector]; i < cell.sector_begin[sector + 1]; ++i) {
    const Cell::Entry& entry = cell.entries[cell.items[i]];
    const Reflector& r = room.reflectors[entry.reflector];
    ExpectedEcho echo;
    Vec2 target;
    bool seen = false;
    switch (r.kind) {
      case ReflectorKind::wall: seen = see_wall(r, view, echo, target); break;
      case ReflectorKind::corner:
      case ReflectorKind::edge: seen = see_point(r, view, echo, target); break;
      case ReflectorKind::all_reflective: seen = see_all_reflective(r, view, echo, target); break;
      case ReflectorKind::mirrored_corner: seen = see_mirrored(room, r, view, echo, target); break;
    }
    if (!seen || echo.chance <= 0.0 || beside_its_door(room, r, view.eye, target)) continue;
    const bool mirrored = r.kind == ReflectorKind::mirrored_corner;
    const double way = mirrored ? distance(target, view.eye) : echo.range;
    if (hidden(room, cell, entry, view.eye, target, way)) continue;
    if (mirrored && hidden(room, cell, entry, scene::in_front_of(target, view.eye, way), r.real, echo.range - way)) continue;
    insert_sorted(list, echo);
  }
  return list;
}

}  // namespace echoway::tracker
