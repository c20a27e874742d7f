#include "routing/doorways.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoway::routing {
namespace {

/// Walls as far apart as this belong to one wall that a plan draws twice, metres.
constexpr double kDoubleWall = 0.15;
/// Cosine of the angle up to which a wall runs along an opening.
const double kParallel = std::cos(degrees(20.0));

Opening snap_to_wall(const Room& room, std::int32_t door, Vec2 at, double width) {
  Opening opening{door, at, {}, 0.5 * width};
  double best = FreeSpace::kDoorSnap;
  for (const Segment& wall : room.walls) {
    const double length = wall.length();
    const double d = distance(wall, at);
    if (!(length > 0.0) || !(d < best)) continue;
    best = d;
    opening.centre = nearest_point(wall, at);
    opening.inward = (1.0 / length) * perpendicular(wall.direction());
  }
  return opening;
}

/// The part [from, to] of `wall`, as parameters, that lies in the opening; empty when it does not run along it.
struct Part {
  double from = 1.0;
  double to = 0.0;
};
Part part_in(const Segment& wall, const Opening& opening) {
  const double length = wall.length();
  if (!(length > 0.0) || opening.inward == Vec2{}) return {};
  const Vec2 along = perpendicular(opening.inward);
  const double cosine = dot(wall.direction(), along) / length;
  if (std::abs(cosine) < kParallel) return {};
  const double t0 = dot(wall.a - opening.centre, along);
  const double per_parameter = cosine * length;
  double from = (-opening.half_width - t0) / per_parameter;
  double to = (opening.half_width - t0) / per_parameter;
  if (from > to) std::swap(from, to);
  from = std::max(from, 0.0);
  to = std::min(to, 1.0);
  if (!(from < to)) return {};
  const Vec2 middle = wall.a + 0.5 * (from + to) * wall.direction();
  return std::abs(dot(middle - opening.centre, opening.inward)) <= kDoubleWall ? Part{from, to} : Part{};
}

}  // namespace

std::vector<Opening> find_openings(const Building& building, RoomIndex room) {
  std::vector<Opening> openings;
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    const Door& door = building.doors[i];
    const auto add = [&](Vec2 at) {
      openings.push_back(snap_to_wall(building.room(room), static_cast<std::int32_t>(i), at, door.width));
    };
    if (door.room_a == room) add(door.at_a);
    if (door.room_b == room) add(door.at_b);
  }
  return openings;
}

CutWalls cut_openings(const std::vector<Segment>& walls, const std::vector<Opening>& openings) {
  CutWalls result;
  std::vector<Segment> pieces;
  for (const Segment& wall : walls) {
    pieces.assign(1, wall);
    for (const Opening& opening : openings) {
      const std::size_t before = pieces.size();
      for (std::size_t i = 0; i < before; ++i) {
        const Segment piece = pieces[i];
        const Part cut = part_in(piece, opening);
        if (!(cut.from < cut.to)) continue;
        const Vec2 p = piece.a + cut.from * piece.direction();
        const Vec2 q = piece.a + cut.to * piece.direction();
        result.doorways.push_back({p, q});
        pieces[i] = {piece.a, p};
        pieces.push_back({q, piece.b});
      }
    }
    for (const Segment& piece : pieces) {
      if (piece.length() > 0.0) result.walls.push_back(piece);
    }
  }
  return result;
}

}  // namespace echoway::routing
