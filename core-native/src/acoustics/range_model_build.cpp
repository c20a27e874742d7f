// How a RangeModel is put together from a room: openings cut, corners checked, obstacles picked.
#include <algorithm>
#include <cmath>

#include "echoway/acoustics/range_model.hpp"

namespace echoway {
namespace {

constexpr double kShortestWall = 1e-9;   // metres; anything shorter has no direction
constexpr double kTouching = 5e-3;       // metres; how far apart ends of one corner may stand in a file
constexpr double kParallelSine = 0.02;   // about 1 degree

bool is_finite(const Segment& s) noexcept { return echoway::is_finite(s.a) && echoway::is_finite(s.b); }

struct Interval {
  double from = 0.0;
  double to = 0.0;
};

// The wall that an opening belongs to; the first one on a tie. Nothing when none is near enough.
const Segment* wall_of(const Opening& opening, const std::vector<Segment>& walls, double reach) noexcept {
  const Segment* nearest = nullptr;
  double least = reach;
  for (const Segment& wall : walls) {
    if (!is_finite(wall) || !(wall.length() > kShortestWall)) continue;
    const double d = distance(wall, opening.at);
    if (d <= least && (nearest == nullptr || d < least)) {
      nearest = &wall;
      least = d;
    }
  }
  return nearest;
}

// Openings cut from `wall`, sorted. An opening is cut from every wall that lies on the line of its own (a wall drawn
// twice, or in two pieces that meet in the doorway).
std::vector<Interval> cuts_of(const Segment& wall, std::span<const Opening> openings,
                              const std::vector<Segment>& walls, double reach) {
  std::vector<Interval> cuts;
  const double length = wall.length();
  const Vec2 along = (1.0 / length) * wall.direction();
  for (const Opening& opening : openings) {
    const Segment* own = wall_of(opening, walls, reach);
    if (own == nullptr) continue;
    const Vec2 own_along = (1.0 / own->length()) * own->direction();
    if (std::abs(cross(along, own_along)) > kParallelSine) continue;
    if (std::abs(cross(along, nearest_point(*own, opening.at) - wall.a)) > kTouching) continue;
    const double middle = dot(opening.at - wall.a, along);
    const Interval cut{std::max(0.0, middle - 0.5 * opening.width), std::min(length, middle + 0.5 * opening.width)};
    if (cut.from < cut.to) cuts.push_back(cut);
  }
  std::sort(cuts.begin(), cuts.end(), [](Interval a, Interval b) { return a.from < b.from; });
  return cuts;
}

// Directions in which walls leave `at`, each once.
std::vector<Vec2> arms_at(Vec2 at, const std::vector<Segment>& walls) {
  std::vector<Vec2> arms;
  const auto add = [&](Vec2 towards) {
    const double length = distance(at, towards);
    if (length <= kTouching) return;
    const Vec2 arm = (1.0 / length) * (towards - at);
    const bool known = std::any_of(arms.begin(), arms.end(), [&](Vec2 other) { return dot(arm, other) > 0.9999; });
    if (!known) arms.push_back(arm);
  };
  for (const Segment& wall : walls) {
    if (!is_finite(wall) || distance(wall, at) > kTouching) continue;
    add(wall.a);
    add(wall.b);
  }
  return arms;
}

// A segment walked along in one direction.
struct Step {
  std::size_t index;
  Vec2 from;
  Vec2 to;
};

// The loop that `segments[first]` is part of, each segment continuing the one before; empty when it does not close, or
// branches. Segments are taken as they come, so whichever end they were written from.
std::vector<Step> closed_loop(const std::vector<Segment>& segments, std::size_t first) {
  const auto meets = [](Vec2 a, Vec2 b) { return squared_norm(a - b) <= kTouching * kTouching; };
  std::vector<Step> loop{{first, segments[first].a, segments[first].b}};
  while (loop.size() <= segments.size()) {
    const Vec2 end = loop.back().to;
    if (loop.size() > 2 && meets(end, loop.front().from)) return loop;
    std::vector<Step> next;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (i == loop.back().index || !is_finite(segments[i]) || segments[i].length() <= kTouching) continue;
      if (meets(segments[i].a, end)) next.push_back({i, segments[i].a, segments[i].b});
      if (meets(segments[i].b, end)) next.push_back({i, segments[i].b, segments[i].a});
    }
    if (next.size() != 1) break;
    loop.push_back(next.front());
  }
  return {};
}

// Andrew's monotone chain; the hull counter-clockwise without its collinear points.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  const auto extend = [&](std::size_t keep, Vec2 p) {
    while (hull.size() > keep && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2 p : points) extend(1, p);
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(lower, *p);
  hull.pop_back();
  return hull;
}

}  // namespace

std::vector<Opening> openings_of(const Building& building, RoomIndex room) {
  std::vector<Opening> openings;
  for (const Door& door : building.doors) {
    if (door.room_a == room) openings.push_back({door.at_a, door.width});
    if (door.room_b == room) openings.push_back({door.at_b, door.width});
  }
  return openings;
}

RangeModel::RangeModel(const Room& room, std::span<const Opening> openings, const BeltConfig& belt,
                       const DetectionTable& detection, const RangeModelParameters& parameters)
    : belt_(belt), detection_(detection) {
  belt_.sensors = std::clamp(belt_.sensors, 1, kMaxSensors);
  belt_.radius_m = std::isfinite(belt_.radius_m) ? std::max(0.0, belt_.radius_m) : 0.0;
  sin_widest_ = std::sin(detection_.widest());
  cos_widest_ = std::cos(detection_.widest());
  lateral_ = belt_.radius_m * sin_widest_;
  edge_reach_ = detection_.reach(ElementKind::edge);
  for (std::size_t i = 0; i < room.edges.size(); ++i) {
    if (echoway::is_finite(room.edges[i])) edges_.push_back({room.edges[i], static_cast<std::int32_t>(i)});
  }
  add_reflectors(room);
  add_walls(room, openings, parameters);
  add_corners(room, parameters.right_angle_tolerance_rad);
  add_occluders();
}

void RangeModel::add_walls(const Room& room, std::span<const Opening> openings,
                           const RangeModelParameters& parameters) {
  auto next_jamb = static_cast<std::int32_t>(room.edges.size());
  const auto add_jamb = [&](Vec2 at) {
    const bool known = std::any_of(edges_.begin(), edges_.end(),
                                   [&](const Edge& e) { return distance(e.at, at) <= parameters.jamb_spacing_m; });
    if (!known) edges_.push_back({at, next_jamb++});
  };
  for (std::size_t i = 0; i < room.walls.size(); ++i) {
    const Segment& wall = room.walls[i];
    if (!is_finite(wall) || !(wall.length() > kShortestWall)) continue;
    const double length = wall.length();
    const Vec2 along = (1.0 / length) * wall.direction();
    const Vec2 normal = perpendicular(along);
    const auto add_piece = [&](double from, double to) {
      if (to - from <= kShortestWall) return;
      walls_.push_back({wall.a + from * along, along, normal, to - from, std::atan2(normal.y, normal.x),
                        static_cast<std::int32_t>(i)});
    };
    double from = 0.0;
    for (const Interval cut : cuts_of(wall, openings, room.walls, parameters.opening_reach_m)) {
      add_piece(from, cut.from);
      if (cut.from > 0.0) add_jamb(wall.a + cut.from * along);
      if (cut.to < length) add_jamb(wall.a + cut.to * along);
      from = std::max(from, cut.to);
    }
    add_piece(from, length);
  }
}

void RangeModel::add_corners(const Room& room, double tolerance) {
  for (std::size_t i = 0; i < room.corners.size(); ++i) {
    const Vec2 at = room.corners[i];
    if (!echoway::is_finite(at)) continue;
    const auto index = static_cast<std::int32_t>(i);
    const std::vector<Vec2> arms = arms_at(at, room.walls);
    // A corner that stands on no wall cannot be checked: the file's word is taken for it.
    if (arms.empty()) corners_.push_back({at, {}, {}, index});
    for (std::size_t a = 0; a < arms.size(); ++a) {
      for (std::size_t b = a + 1; b < arms.size(); ++b) {
        if (std::abs(dot(arms[a], arms[b])) <= std::sin(tolerance)) corners_.push_back({at, arms[a], arms[b], index});
      }
    }
  }
}

// Reflectors that close on themselves outline a solid thing, a bench or a cupboard; from outside its far sides are
// never seen, and saying so now spares looking for them behind its near ones.
void RangeModel::add_reflectors(const Room& room) {
  const auto& all = room.reflectors;
  std::vector<Vec2> outward(all.size());
  std::vector<bool> done(all.size(), false);
  for (std::size_t first = 0; first < all.size(); ++first) {
    const std::vector<Step> loop = done[first] ? std::vector<Step>{} : closed_loop(all, first);
    double area = 0.0;  // twice, counter-clockwise positive
    for (const Step& step : loop) {
      done[step.index] = true;
      area += cross(step.from - loop.front().from, step.to - loop.front().from);
    }
    for (const Step& step : loop) {
      const Vec2 right = -perpendicular(step.to - step.from);
      outward[step.index] = ((area > 0.0 ? 1.0 : -1.0) / norm(right)) * right;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_finite(all[i])) reflectors_.push_back({all[i], outward[i], static_cast<std::int32_t>(i)});
  }
}

// Nothing on the outline of the whole room's convex hull can stand between two points inside it; in a plain room that
// leaves no obstacle at all.
void RangeModel::add_occluders() {
  std::vector<Vec2> points;
  for (const Wall& wall : walls_) {
    points.push_back(wall.a);
    points.push_back(wall.a + wall.length * wall.along);
  }
  for (const Reflector& r : reflectors_) {
    points.push_back(r.segment.a);
    points.push_back(r.segment.b);
  }
  for (const Corner& corner : corners_) points.push_back(corner.at);
  for (const Edge& edge : edges_) points.push_back(edge.at);
  const std::vector<Vec2> hull = convex_hull(std::move(points));

  double diameter = 0.0;
  for (const Vec2 a : hull) {
    for (const Vec2 b : hull) diameter = std::max(diameter, distance(a, b));
  }
  greatest_range_ = std::min(diameter, belt_.max_range_m);
  const double on_line = 1e-9 * diameter;

  for (const Wall& wall : walls_) {
    double low = 0.0;
    double high = 0.0;
    for (const Vec2 p : hull) {
      low = std::min(low, dot(p - wall.a, wall.normal));
      high = std::max(high, dot(p - wall.a, wall.normal));
    }
    if (low < -on_line && high > on_line) occluders_.push_back({wall.a, wall.a + wall.length * wall.along});
  }
  for (const Reflector& r : reflectors_) {
    if (r.segment.length() > kShortestWall) occluders_.push_back(r.segment);
  }
}

}  // namespace echoway
