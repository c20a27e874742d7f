#include "echoway/locate/start_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "echoway/geometry/box.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "text/format.hpp"

namespace echoway {
namespace {

std::string point(Vec2 at) { return "(" + text::brief(at.x) + ", " + text::brief(at.y) + ")"; }

double distance_to_outline(const Room& room, Vec2 at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec2>& loop : room.boundary) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      nearest = std::min(nearest, distance(Segment{loop[i], loop[(i + 1) % loop.size()]}, at));
    }
  }
  return nearest;
}

Status check_position(Vec2 at, const Room& room) {
  const double away = distance_to_outline(room, at);
  if (away <= kBesideRoom || contains(room.boundary, at)) return success();
  const Box floor = box_about(room.boundary);
  return Error{"the start " + point(at) + " lies " + text::brief(away) + " m outside room " + room.id +
               ", whose floor is between " + point(floor.low) + " and " + point(floor.high) + " m in its own frame"};
}

}  // namespace

Status check_start(const Start& start, const Building& building) {
  const bool has_room = start.room.has_value();
  if (has_room && !building.has_room(*start.room)) {
    return Error{"the start names a room that the building does not have"};
  }
  if (!has_room && (start.position || start.heading)) return Error{"a start position or heading needs its room"};
  if (start.position && !is_finite(*start.position)) return Error{"the start position is not finite"};
  if (start.heading && !std::isfinite(*start.heading)) return Error{"the start heading is not finite"};
  return start.position ? check_position(*start.position, building.room(*start.room)) : success();
}

}  // namespace echoway
