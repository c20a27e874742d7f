#pragma once

#include <vector>

#include "echoway/building/building.hpp"

/// Rooms that tests build in code.
namespace echoway::rooms {

/// Walls and boundary along `outline` (counter-clockwise); every vertex that turns left is a corner, right an edge.
inline Room polygon(const std::vector<Vec2>& outline) {
  Room room;
  room.id = "P";
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 before = outline[(i + outline.size() - 1) % outline.size()];
    const Vec2 at = outline[i];
    const Vec2 after = outline[(i + 1) % outline.size()];
    room.walls.push_back({at, after});
    (cross(at - before, after - at) > 0.0 ? room.corners : room.edges).push_back(at);
  }
  room.boundary = {outline};
  return room;
}

/// Walls 0 south, 1 east, 2 north, 3 west; corners counter-clockwise from the origin.
inline Room rectangle(double width, double height) {
  return polygon({{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}});
}

/// 6 x 4 m with a pier from (2, 0) to (3, 1.5) out of the south wall. Its west side is wall 1; edge 0 is (2, 1.5);
/// corner 3 is (6, 0).
inline Room with_pier() {
  return polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {3.0, 1.5}, {3.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}});
}

/// The thesis's sample room (figure 5.1, table 5.2), feet in the table, metres here.
inline Room sample_room() {
  const std::vector<Vec2> outline_ft = {{0.0, 6.45}, {0.0, 0.0},  {19.0, 0.0}, {19.0, 22.0}, {4.0, 22.0},
                                        {4.0, 20.0}, {0.0, 20.0}, {0.0, 7.5},  {4.0, 7.5},   {4.0, 6.45}};
  std::vector<Vec2> outline;
  for (const Vec2 p : outline_ft) outline.push_back(kMetresPerFoot * p);
  Room room = polygon(outline);
  room.edges.push_back({feet(19.0), feet(15.0)});
  room.edges.push_back({feet(19.0), feet(19.0)});
  return room;
}

/// The same room elsewhere: every point taken through `to`.
inline Room moved(Room room, const Pose2& to) {
  const auto move = [&](Segment& s) { s = {to.transform(s.a), to.transform(s.b)}; };
  for (Segment& wall : room.walls) move(wall);
  for (Segment& reflector : room.reflectors) move(reflector);
  for (Vec2& corner : room.corners) corner = to.transform(corner);
  for (Vec2& edge : room.edges) edge = to.transform(edge);
  for (auto& loop : room.boundary) {
    for (Vec2& point : loop) point = to.transform(point);
  }
  return room;
}

}  // namespace echoway::rooms
