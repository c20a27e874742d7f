#include "plans/plans.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echoway::plans {

Room polygon_room(std::string id, const std::vector<Vec2>& loop) {
  Room room;
  room.id = std::move(id);
  room.boundary = {loop};
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = loop[(i + n - 1) % n];
    const Vec2 here = loop[i];
    const Vec2 after = loop[(i + 1) % n];
    room.walls.push_back({here, after});
    const double turn = cross(here - before, after - here);
    const double size = norm(here - before) * norm(after - here);
    if (turn < 0.0) {
      room.edges.push_back(here);
    } else if (std::fabs(dot(here - before, after - here)) < 1e-6 * size) {
      room.corners.push_back(here);
    }
  }
  return room;
}

Room box_room(std::string id, double width, double height) {
  return polygon_room(std::move(id), {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}});
}

Room l_room(std::string id) {
  return polygon_room(std::move(id), {{0.0, 0.0}, {6.0, 0.0}, {6.0, 2.5}, {3.5, 2.5}, {3.5, 5.0}, {0.0, 5.0}});
}

Room comb_room(std::string id, int walls) {
  // The spine's lower side and its ends are three walls; n teeth with the gaps between them are 4n - 1 more, and the
  // left end of the spine goes straight up the first tooth.
  const int teeth = walls / 4;
  std::vector<Vec2> loop{{0.0, 0.0}, {2.0 * teeth - 1.0, 0.0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double left = 2.0 * i;
    loop.push_back({left + 1.0, 5.0});
    loop.push_back({left, 5.0});
    if (i > 0) {
      loop.push_back({left, 2.0});
      loop.push_back({left - 1.0, 2.0});
    }
  }
  return polygon_room(std::move(id), loop);
}

Building three_rooms() {
  Building building;
  building.name = "Three rooms";
  building.unit = LengthUnit::metres;
  building.rooms = {box_room("hall", 5.0, 4.0), l_room("office"), box_room("store", 5.0, 3.0)};
  building.rooms[1].frame.position = {5.0, 0.0};
  building.rooms[2].frame.position = {0.0, 4.0};
  building.doors = {{0, {5.0, 2.0}, 1, {0.0, 2.0}, 0.9}, {1, {0.0, 4.5}, 2, {5.0, 0.5}, 0.9}};
  return building;
}

Building two_closets() {
  Building building;
  building.unit = LengthUnit::metres;
  building.rooms = {box_room("large", 2.5, 2.5), box_room("small", 2.5, 2.0)};
  building.rooms[1].frame.position = {2.5, 0.0};
  building.doors = {{0, {2.5, 1.0}, 1, {0.0, 1.0}, 0.9}};
  return building;
}

Building guided_closets() {
  Building building = two_closets();
  building.exits = {{0, {0.0, 1.0}, "way out"}};
  building.places = {{1, {1.5, 1.0}, "shelf"}};
  building.links = {{LevelLinkKind::stairs, 0, {0.6, 2.0}, 1, {2.0, 0.6}}};
  return building;
}

Building alone(Room room) {
  Building building;
  building.unit = LengthUnit::metres;
  building.rooms = {std::move(room)};
  return building;
}

Vec2 Motion::apply(Vec2 p) const noexcept {
  const Vec2 e = unit_from_angle(turn);
  const double x = mirrored ? -p.x : p.x;
  return {shift.x + e.x * x - e.y * p.y, shift.y + e.y * x + e.x * p.y};
}

double Motion::apply_heading(double heading) const noexcept {
  return wrap_angle(turn + (mirrored ? kPi - heading : heading));
}

Room moved(Room room, const Motion& motion) {
  const auto move = [&](Vec2& p) { p = motion.apply(p); };
  for (std::vector<Segment>* segments : {&room.walls, &room.reflectors}) {
    for (Segment& s : *segments) {
      move(s.a);
      move(s.b);
    }
  }
  for (std::vector<Vec2>* points : {&room.corners, &room.edges}) std::for_each(points->begin(), points->end(), move);
  for (std::vector<Vec2>& loop : room.boundary) {
    std::for_each(loop.begin(), loop.end(), move);
    if (motion.mirrored) std::reverse(loop.begin(), loop.end());
  }
  return room;
}

}  // namespace echoway::plans
