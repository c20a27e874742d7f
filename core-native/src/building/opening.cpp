#include "echoway/building/opening.hpp"

#include <limits>
#include <utility>

#include "geometry/floor_tracing.hpp"

namespace echoway {
namespace {

/// The part of `wall`, as distances from its first end, that `span` covers when it runs along it.
std::optional<std::pair<double, double>> covered(const Segment& wall, const Segment& span) {
  const double length = wall.length();
  if (!(length > 0.0)) return std::nullopt;
  const Vec2 along = (1.0 / length) * wall.direction();
  const double off_a = std::abs(cross(along, span.a - wall.a));
  const double off_b = std::abs(cross(along, span.b - wall.a));
  if (std::max(off_a, off_b) > kSnapDistance) return std::nullopt;
  const auto [low, high] = std::minmax({dot(along, span.a - wall.a), dot(along, span.b - wall.a)});
  const std::pair<double, double> part{std::max(low, 0.0), std::min(high, length)};
  if (part.second - part.first <= kSamePoint) return std::nullopt;
  return part;
}

void cut(std::vector<Segment>& pieces, const Segment& span) {
  std::vector<Segment> left;
  for (const Segment& piece : pieces) {
    const auto part = covered(piece, span);
    if (!part) {
      left.push_back(piece);
      continue;
    }
    const double length = piece.length();
    const Vec2 along = (1.0 / length) * piece.direction();
    if (part->first > kSamePoint) left.push_back({piece.a, piece.a + part->first * along});
    if (length - part->second > kSamePoint) left.push_back({piece.a + part->second * along, piece.b});
  }
  pieces = std::move(left);
}

}  // namespace

std::optional<DoorOpening> find_opening(const Room& room, Vec2 at, double width) {
  if (!(width > 0.0)) return std::nullopt;
  DoorOpening opening;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < room.walls.size(); ++i) {
    const double d = distance(room.walls[i], at);
    if (d < nearest && room.walls[i].length() > 0.0) {
      nearest = d;
      opening.wall = i;
    }
  }
  if (!(nearest <= kDoorReach)) return std::nullopt;
  const Segment& wall = room.walls[opening.wall];
  const double length = wall.length();
  const double centre = nearest_parameter(wall, at) * length;
  const Vec2 along = (1.0 / length) * wall.direction();
  opening.span = {wall.a + std::max(centre - 0.5 * width, 0.0) * along,
                  wall.a + std::min(centre + 0.5 * width, length) * along};
  return opening;
}

std::vector<std::vector<DoorOpening>> find_openings(const Building& building) {
  std::vector<std::vector<DoorOpening>> openings(building.rooms.size());
  for (std::size_t door = 0; door < building.doors.size(); ++door) {
    const Door& d = building.doors[door];
    const auto add = [&](RoomIndex room, Vec2 at, RoomIndex beyond) {
      std::optional<DoorOpening> opening = find_opening(building.room(room), at, d.width);
      if (!opening) return;
      opening->door = door;
      opening->beyond = beyond;
      openings[static_cast<std::size_t>(room)].push_back(*opening);
    };
    add(d.room_a, d.at_a, d.room_b);
    add(d.room_b, d.at_b, d.room_a);
  }
  return openings;
}

std::vector<Segment> walls_with_doors_open(const Room& room, const std::vector<DoorOpening>& openings) {
  std::vector<Segment> out;
  for (const Segment& wall : room.walls) {
    std::vector<Segment> pieces{wall};
    for (const DoorOpening& opening : openings) cut(pieces, opening.span);
    out.insert(out.end(), pieces.begin(), pieces.end());
  }
  return out;
}

}  // namespace echoway
