#include "scene/view.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {
namespace {

constexpr int kDoorsDeep = 2;
constexpr double kDoorReflectivity = 0.9;
constexpr double kSetBack = 0.04;  // Of a shut door behind the wall's face, metres, when the plan shows no thickness.
constexpr int kMostHops = 8;
constexpr double kSkin = 1e-3;  // Metres from either end of a line within which nothing blocks it.

RoomScene moved(const RoomScene& scene, const Pose2& frame) {
  RoomScene out = scene;
  const Vec2 e = unit_from_angle(frame.heading);
  const auto move = [&](Vec2 p) { return frame.position + rotated(p, e); };
  for (Panel& panel : out.panels) panel.at = {move(panel.at.a), move(panel.at.b)};
  for (Corner& corner : out.corners) {
    corner.at = move(corner.at);
    corner.u = rotated(corner.u, e);
    corner.v = rotated(corner.v, e);
  }
  for (Scatterer& scatterer : out.scatterers) scatterer.at = move(scatterer.at);
  return out;
}

Segment moved(const Segment& segment, const Pose2& frame) {
  return {frame.transform(segment.a), frame.transform(segment.b)};
}

// Where along from + s * along (s in metres, 0 ... length) the line crosses the segment; negative when it does not.
double crossing(Vec2 from, Vec2 along, double length, const Segment& segment) noexcept {
  const Vec2 d = segment.direction();
  const double denominator = cross(along, d);
  if (denominator == 0.0) return -1.0;
  const Vec2 to_a = segment.a - from;
  const double t = cross(to_a, along) / denominator;
  if (t < 0.0 || t > 1.0) return -1.0;
  const double s = cross(to_a, d) / denominator;
  return s > length ? -1.0 : s;
}

// A shut door lies a little behind the wall's face; with the sides of its passage it makes shallow corners.
void shut(const Doorway& doorway, const Pose2& frame, RoomScene& scene) {
  const double depth = std::max(kSetBack, distance(doorway.middle(), doorway.centre()));
  const Vec2 back = -depth * doorway.inward;
  const Vec2 axis = unit_from_angle(frame.heading);
  const Segment leaf = moved(Segment{doorway.opening.a + back, doorway.opening.b + back}, frame);
  const Vec2 along = rotated(doorway.along(), axis);
  const Vec2 inward = rotated(doorway.inward, axis);
  scene.panels.push_back({leaf, kDoorReflectivity});
  scene.corners.push_back({leaf.a, along, inward, doorway.width(), depth, kDoorReflectivity});
  scene.corners.push_back({leaf.b, -along, inward, doorway.width(), depth, kDoorReflectivity});
}

}  // namespace

View::View(RoomIndex centre, Surroundings& surroundings) { place(centre, Pose2{}, {}, 0, surroundings); }

void View::place(RoomIndex room, const Pose2& frame, const Entrance& entrance, int depth, Surroundings& surroundings) {
  const std::size_t self = rooms_.size();
  rooms_.push_back({room, frame, moved(surroundings.scene(room), frame), {}});
  const std::vector<Doorway>& doorways = surroundings.doorways(room);
  for (std::size_t i = 0; i < doorways.size(); ++i) {
    const Doorway& doorway = doorways[i];
    const Segment threshold = moved(doorway.threshold, frame);
    if (!surroundings.is_open(doorway.door)) {
      shut(doorway, frame, rooms_[self].scene);
      continue;
    }
    if (const std::optional<Segment> leaf = surroundings.leaf(room, doorway)) {
      rooms_[self].scene.panels.push_back({moved(*leaf, frame), kDoorReflectivity});
    }
    if (entrance.from >= 0 && i == entrance.doorway) {
      rooms_[self].portals.push_back({threshold, entrance.from});
    } else if (depth < kDoorsDeep) {
      rooms_[self].portals.push_back({threshold, static_cast<int>(rooms_.size())});
      place(doorway.other, frame.compose(doorway.other_frame), {static_cast<int>(self), doorway.twin}, depth + 1,
            surroundings);
    } else {
      rooms_[self].portals.push_back({threshold, -1});
    }
  }
}

// Walks along the ray from room to room. Stops at the first panel between kSkin and `reach`, or at the end.
View::Hit View::first_panel(int room, Vec2 from, Vec2 direction, double reach) const noexcept {
  double entered = kSkin;
  int came_from = -1;
  for (int hops = 0; hops < kMostHops; ++hops) {
    const PlacedRoom& here = rooms_[static_cast<std::size_t>(room)];
    double limit = reach;
    const Portal* through = nullptr;
    for (const Portal& portal : here.portals) {
      if (came_from >= 0 && portal.leads_to == came_from) continue;
      const double s = crossing(from, direction, reach, portal.opening);
      if (s >= entered - kSkin && s >= 0.0 && s < limit) {
        limit = s;
        through = &portal;
      }
    }
    const Panel* hit = nullptr;
    for (const Panel& panel : here.scene.panels) {
      const double s = crossing(from, direction, limit, panel.at);
      if (s > entered && s < limit) {
        limit = s;
        hit = &panel;
      }
    }
    if (hit != nullptr) return {hit, room};
    if (through == nullptr) return {nullptr, room};
    if (through->leads_to < 0) return {nullptr, -1};
    came_from = room;
    room = through->leads_to;
    entered = limit;
  }
  return {nullptr, -1};
}

int View::trace(int room, Vec2 from, Vec2 to) const noexcept {
  const Vec2 whole = to - from;
  const double length = norm(whole);
  if (length < kSkin) return room;
  const Hit hit = first_panel(room, from, (1.0 / length) * whole, length - kSkin);
  return hit.panel == nullptr ? hit.room : -1;
}

}  // namespace echoway::sim
