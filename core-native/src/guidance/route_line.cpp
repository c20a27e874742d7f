#include "guidance/route_line.hpp"

#include <cmath>

namespace echoway::guidance {
namespace {

double heading_of(Vec2 from, Vec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

}  // namespace

void lay_out(const Route& route, const Building& building, std::vector<LinePoint>& line) {
  line.clear();
  Pose2 frame;  // takes the current room's frame into the line's
  for (const Waypoint& w : route.waypoints) {
    line.push_back({frame.transform(w.at), w.kind, w.index});
    if (w.kind == WaypointKind::link_from) return;
    if (w.kind != WaypointKind::door) continue;
    // Chained at this door and not by the rooms' own frames: loops of doors need not close.
    const double turn = building.room(w.next_room).frame.heading - building.room(w.room).frame.heading;
    Pose2 next{{}, wrap_angle(frame.heading + turn)};
    next.position = line.back().at - next.transform(w.next_at);
    frame = next;
  }
}

Manoeuvre next_manoeuvre(std::span<const LinePoint> line, double least, double fuse) noexcept {
  constexpr double kPoint = 1e-6;
  constexpr double kStraight = 0.03;  // bends smaller than this are none, radians
  double walked = 0.0;
  double in = 0.0;
  bool moving = false;
  for (std::size_t i = 1; i + 1 < line.size();) {
    const double leg = distance(line[i - 1].at, line[i].at);
    walked += leg;
    if (leg > kPoint && !moving) {
      in = heading_of(line[i - 1].at, line[i].at);
      moving = true;
    }
    std::size_t j = i;
    double within = 0.0;
    double before = 0.0;
    double out = in;
    double angle = 0.0;
    // Take in further vertices while the legs between them are short and bend the same way.
    while (true) {
      const double next = distance(line[j].at, line[j + 1].at);
      const double heading = next > kPoint ? heading_of(line[j].at, line[j + 1].at) : out;
      const double bend = wrap_angle(heading - in);
      if (j > i && !(bend * angle > 0.0 && std::abs(bend) > std::abs(angle) + kStraight)) {
        within = before;
        --j;
        break;
      }
      out = heading;
      angle = bend;
      if (!moving || j + 2 >= line.size() || next > fuse) break;
      before = within;
      within += next;
      ++j;
    }
    if (moving && std::abs(angle) > least) {
      const double run_out = distance(line[j].at, line[std::min(j + 1, line.size() - 1)].at);
      return {true, walked + 0.5 * (j > i ? within : 0.0), out, run_out, i, j};
    }
    in = out;
    moving = true;
    ++i;
  }
  return {};
}

Vec2 point_along(std::span<const LinePoint> line, double along) noexcept {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double leg = distance(line[i - 1].at, line[i].at);
    if (along <= leg && leg > 0.0) return line[i - 1].at + (along / leg) * (line[i].at - line[i - 1].at);
    along -= leg;
  }
  return line.back().at;
}

double length_of(std::span<const LinePoint> line) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1].at, line[i].at);
  return length;
}

}  // namespace echoway::guidance
