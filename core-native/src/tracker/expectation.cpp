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

constexpr double kBeamEdgeSpread = 0.035;   // Radians by which the beam's edge is uncertain.
constexpr double kRoughSpread = 0.06;       // Radians within the beam from which a rough wall's echo comes;
constexpr double kCoarseRoughSpread = 0.10; // the same of particles that stand for cells of headings.
constexpr double kOffTheBeam = 0.02;        // A wall heard squarely less often is heard by its roughness, if at all.
constexpr double kNearest = 1e-6;

struct View {
  Vec2 eye;         // The transducer.
  Vec2 axis;        // Its direction.
  bool coarse;
  const EchoModel& model;
};

// An echo, and where sound turns back for it: what must be in sight.
struct Sighting {
  ExpectedEcho echo;
  double target_x, target_y;

  [[nodiscard]] Vec2 target() const noexcept { return {target_x, target_y}; }
};

Sighting sighting(double range, double chance, double extra_variance, Vec2 gradient, Vec2 target) noexcept {
  return {{range, chance, extra_variance, gradient.x, gradient.y, 0, false}, target.x, target.y};
}

// A rough wall answers from where the axis meets it, give or take what the beam's width blurs.
bool see_rough_wall(const Reflector& r, const View& view, double d, Vec2 normal, Sighting& seen) noexcept {
  const double cosine = -dot(view.axis, normal);
  if (view.model.too_askew(cosine)) return false;
  const double way = d / std::max(cosine, 0.01);
  const double chance = view.model.rough(cosine, way);
  if (chance <= 0.0) return false;
  const Vec2 target = view.eye + way * view.axis;
  const double t = r.along(target);
  if (t < 0.0 || t > r.length) return false;
  const double spread = view.coarse ? kCoarseRoughSpread : kRoughSpread;
  const double blur = way * std::abs(cross(view.axis, normal)) / cosine * spread;
  seen = sighting(way, chance, blur * blur, (1.0 / cosine) * normal, target);
  return true;
}

bool see_wall(const Reflector& r, const View& view, Sighting& seen) noexcept {
  double d = r.signed_distance(view.eye);
  Vec2 normal = r.normal;
  if (d < 0.0 && r.two_sided) {
    d = -d;
    normal = -normal;
  }
  if (!(d > kNearest) || !(dot(view.axis, normal) < 0.0)) return false;
  const double beam = view.model.beam(std::abs(cross(view.axis, normal)), view.coarse);
  if (beam <= kOffTheBeam) return see_rough_wall(r, view, d, normal, seen);
  const double soft = view.coarse ? scene::kCoarseWallEndSoftness : scene::kWallEndSoftness;
  const double t = r.along(view.eye);
  const double inside = std::min(t, r.length - t);
  if (inside <= -soft) return false;
  double chance = beam * view.model.reach(ReflectorKind::wall, d);
  if (inside < soft) chance *= 0.5 * (1.0 + inside / soft);
  seen = sighting(d, chance, 0.0, normal, view.eye - d * normal);
  seen.echo.of_wall = true;
  return true;
}

bool see_point(const Reflector& r, const View& view, Sighting& seen) noexcept {
  const Vec2 way = r.a - view.eye;
  const double d2 = squared_norm(way);
  if (!(d2 > kNearest * kNearest) || !(dot(view.axis, way) > 0.0)) return false;
  const double aside = cross(view.axis, way);
  // Most are outside: no root, no division for them.
  if (aside * aside > view.model.outside_beam2(view.coarse) * d2) return false;
  const double d = std::sqrt(d2);
  const Vec2 direction = (1.0 / d) * way;
  const double beam = view.model.beam(std::abs(cross(view.axis, direction)), view.coarse);
  if (beam <= 0.0) return false;
  seen = sighting(d, beam * view.model.reach(r.kind, d), 0.0, -direction, r.a);
  return true;
}

// Where one edge of the beam, along `ray`, meets an all-reflective element, if nearer than what is `seen` already.
bool see_at_beam_edge(const Reflector& r, const View& view, Vec2 ray, bool found, Sighting& seen) noexcept {
  const double approach = -dot(r.normal, ray);
  if (std::abs(approach) < 0.1) return found;
  const double way = r.signed_distance(view.eye) / approach;
  if (!(way > kNearest) || (found && way >= seen.echo.range)) return found;
  const Vec2 hit = view.eye + way * ray;
  const double t = r.along(hit);
  if (t < 0.0 || t > r.length) return found;
  const double slope = way * std::abs(dot(r.tangent(), ray)) / std::abs(approach) * kBeamEdgeSpread;
  const double chance = view.model.reach(ReflectorKind::all_reflective, way);
  seen = sighting(way, chance, slope * slope, (1.0 / approach) * r.normal, hit);
  return true;
}

// The nearest point of the element inside the beam: its nearest point if that is inside, else where the beam's edge
// meets it.
bool see_all_reflective(const Reflector& r, const View& view, Sighting& seen) noexcept {
  const Vec2 nearest = nearest_point({r.a, r.b}, view.eye);
  const Vec2 way = nearest - view.eye;
  const double d = std::sqrt(squared_norm(way));
  const double cosine = view.model.half_beam_cosine();
  if (d > kNearest && dot(view.axis, way) >= cosine * d) {
    seen = sighting(d, view.model.reach(ReflectorKind::all_reflective, d), 0.0, (-1.0 / d) * way, nearest);
    return true;
  }
  bool found = false;
  for (const double sine : {view.model.half_beam_sine(), -view.model.half_beam_sine()}) {
    const Vec2 ray = rotated(view.axis, {cosine, sine});
    found = see_at_beam_edge(r, view, ray, found, seen);
  }
  return found;
}

// A corner's image behind a wall, seen through it as through a window: the target is where the sound meets the wall.
bool see_mirrored(const RoomScene& room, const Reflector& r, const View& view, Sighting& seen) noexcept {
  if (!see_point(r, view, seen)) return false;
  const Reflector& wall = room.reflectors[static_cast<std::size_t>(r.mirror)];
  const double before = wall.signed_distance(view.eye);
  const double behind = wall.signed_distance(r.a);
  if (!(before * behind < 0.0)) return false;
  const Vec2 via = view.eye + before / (before - behind) * (r.a - view.eye);
  const double t = wall.along(via);
  seen.target_x = via.x;
  seen.target_y = via.y;
  return t > 0.0 && t < wall.length;
}

bool see(const RoomScene& room, const Reflector& r, const View& view, Sighting& seen) noexcept {
  switch (r.kind) {
    case ReflectorKind::wall: return see_wall(r, view, seen);
    case ReflectorKind::corner:
    case ReflectorKind::edge: return see_point(r, view, seen);
    case ReflectorKind::all_reflective: return see_all_reflective(r, view, seen);
    case ReflectorKind::mirrored_corner: return see_mirrored(room, r, view, seen);
  }
  return false;
}

bool hidden(const RoomScene& room, const Cell& cell, const Cell::Entry& entry, Vec2 eye, Vec2 target,
            double way) noexcept {
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
  return !scene::blocks(door.span(), eye, target) &&
         squared_norm(eye - door.centre) >= scene::kInDoorway * scene::kInDoorway;
}

// Whether the echo of `r`, an entry of `cell`, comes back unhindered.
bool comes_back(const RoomScene& room, const Cell& cell, const Cell::Entry& entry, const Reflector& r, Vec2 eye,
                const Sighting& seen) noexcept {
  const Vec2 target = seen.target();
  if (beside_its_door(room, r, eye, target)) return false;
  if (entry.occluder_count == 0) return true;
  if (r.kind != ReflectorKind::mirrored_corner) return !hidden(room, cell, entry, eye, target, seen.echo.range);
  const double way = distance(target, eye);
  return !hidden(room, cell, entry, eye, target, way) &&
         !hidden(room, cell, entry, scene::in_front_of(target, eye, way), r.b, seen.echo.range - way);
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

View view_of(const Particle& p, const Shot& shot, const EchoModel& model) noexcept {
  const Vec2 axis = axis_of(p, shot);
  return {p.position + shot.radius * axis, axis, shot.coarse, model};
}

ExpectedEchoes look(const Cell& cell, const RoomScene& room, const Particle& p, const Shot& shot,
                    const View& view) noexcept {
  const double turns = (p.heading + shot.bearing_rad) * (1.0 / kTwoPi);
  const double part = turns - std::floor(turns);
  const auto sector = std::min(static_cast<std::size_t>(part * Cell::kSectors), std::size_t{Cell::kSectors - 1});

  ExpectedEchoes list;
  for (unsigned i = cell.sector_begin[sector]; i < cell.sector_begin[sector + 1]; ++i) {
    const unsigned item = cell.items[i];
    if (item >= Cell::kCoarseOnly && !view.coarse) continue;
    const Cell::Entry& entry = cell.entries[item % Cell::kCoarseOnly];
    const Reflector& r = room.reflectors[entry.reflector];
    Sighting seen;
    if (!see(room, r, view, seen) || seen.echo.chance <= 0.0) continue;
    seen.echo.reflector = entry.reflector;
    if (comes_back(room, cell, entry, r, view.eye, seen)) insert_sorted(list, seen.echo);
  }
  return list;
}

}  // namespace

ExpectedEchoes expect(const Particle& p, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept {
  const View view = view_of(p, shot, model);
  return look(scene.cell_at(p.room, view.eye), scene.room(p.room), p, shot, view);
}

ExpectedEchoes expect_from(const Cell& cell, const RoomScene& room, const Particle& p, const Shot& shot,
                           const EchoModel& model) noexcept {
  return look(cell, room, p, shot, view_of(p, shot, model));
}

}  // namespace echoway::tracker
