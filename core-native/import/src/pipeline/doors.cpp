#include "pipeline/doors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <tuple>

#include "echoway/geometry/segment.hpp"
#include "echoway/units.hpp"

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kDefaultWidth = feet(3.0);  // when the plan gives a point only (as in the building format)
constexpr double kWallReach = 0.6;       // metres to look for floor on either side of a door drawn as a line
constexpr double kFrameReach = 0.35;     // the same from the face of a door drawn as an area
constexpr double kStep = 0.02;           // metres between looks
constexpr double kSnapReach = 0.75;      // metres by which a door may stand off its wall
constexpr double kMinWidth = 0.4;        // metres
constexpr double kCurve = 0.7;           // cosine of the turn up to which short edges are pieces of one curved wall
constexpr double kLeafGap = 0.15;        // metres between leaves of one door
constexpr double kInset = 1e-3;          // metres; a look this far inside a cell is certain

// A door before it is known what it joins.
struct Candidate {
  Vec2 centre, along;
  double width = 0.0;
  double half_depth = 0.0;  ///< Half the extent of its area across the wall.
};

struct Side {
  enum class Kind { cell, outside, blocked } kind = Kind::blocked;
  int cell = -1;
  double distance = 0.0;
};

// What lies beyond a door in direction `n`: three looks across its width, the two that agree count.
class Looker {
 public:
  explicit Looker(const LevelFloor& floor) : floor_(floor) {}

  [[nodiscard]] Side look(const Candidate& door, Vec2 n, double reach) const {
    std::array<Side, 3> looks{};
    for (int i = -1; i <= 1; ++i) {
      looks[static_cast<std::size_t>(i + 1)] = look_from(door.centre + (0.25 * i * door.width) * door.along, n, reach);
    }
    const auto votes = [&](const Side& s) {
      return std::count_if(looks.begin(), looks.end(),
                           [&](const Side& t) { return t.kind == s.kind && t.cell == s.cell; });
    };
    Side best = looks[1];
    for (const Side& s : looks) {
      if (votes(s) > votes(best) || (best.kind == Side::Kind::blocked && s.kind != Side::Kind::blocked)) best = s;
    }
    for (const Side& s : looks) {
      if (s.kind == best.kind && s.cell == best.cell) best.distance = std::min(best.distance, s.distance);
    }
    return best;
  }

 private:
  [[nodiscard]] Side look_from(Vec2 from, Vec2 n, double reach) const {
    for (double d = kInset; d <= reach; d += kStep) {
      const int cell = floor_.cell_at(from + d * n);
      if (cell >= 0) return {Side::Kind::cell, cell, refine(from, n, d, cell)};
    }
    const Vec2 beyond = from + reach * n;
    const bool outside = !geos::contains(floor_.inside, beyond) || geos::contains(floor_.outdoors, beyond);
    return {outside ? Side::Kind::outside : Side::Kind::blocked, -1, reach};
  }

  // Where exactly the cell begins, to a tenth of a millimetre.
  [[nodiscard]] double refine(Vec2 from, Vec2 n, double inside, int cell) const {
    const Shape& area = floor_.cells[static_cast<std::size_t>(cell)].floor;
    double outside = std::max(0.0, inside - kStep);
    while (inside - outside > geos::kGrid) {
      const double middle = 0.5 * (inside + outside);
      (geos::contains(area, from + middle * n) ? inside : outside) = middle;
    }
    return inside;
  }

  const LevelFloor& floor_;
};

struct Sides {
  Side front, back;
  [[nodiscard]] int score() const {
    const auto worth = [](const Side& s) { return s.kind == Side::Kind::cell ? 2 : s.kind == Side::Kind::outside ? 1 : 0; };
    const bool same = front.kind == Side::Kind::cell && back.kind == Side::Kind::cell && front.cell == back.cell;
    return worth(front) + worth(back) - (same ? 2 : 0);
  }
};

class Placer {
 public:
  Placer(const LevelFloor& floor, Report* report) : floor_(floor), looker_(floor), report_(report) {}

  DoorPlacement place() {
    for (std::size_t i = 0; i < floor_.plan->doors.size(); ++i) place_one(i, floor_.plan->doors[i]);
    join_leaves(placement_.doors);
    join_leaves(placement_.exits);
    return std::move(placement_);
  }

 private:
  void place_one(std::size_t index, const PlanDoor& door) {
    Candidate candidate;
    Sides sides;
    if (!door.area.empty()) {
      std::tie(candidate, sides) = from_area(door);
    } else if (!from_path(door, candidate, sides)) {
      return;
    }
    if (sides.front.kind == Side::Kind::cell && sides.back.kind == Side::Kind::cell &&
        sides.front.cell == sides.back.cell) {
      if (!door.area.empty()) {
        placement_.within_a_cell.insert(index);
      } else {
        unresolved(door, candidate.centre, "has the same room on both sides: left out");
      }
      return;
    }
    keep(door, candidate, sides);
  }

  // The wall runs along the side of the door's rectangle across which there is floor on both sides; the longer one when
  // both do.
  std::pair<Candidate, Sides> from_area(const PlanDoor& door) const {
    const geos::Box box = geos::oriented_box(shape_of(door.area));
    const Candidate lengthwise{box.centre, box.along, box.length, 0.5 * box.width};
    const Candidate crosswise{box.centre, perpendicular(box.along), box.width, 0.5 * box.length};
    const Sides a = sides_of(lengthwise, lengthwise.half_depth + kFrameReach);
    const Sides b = sides_of(crosswise, crosswise.half_depth + kFrameReach);
    const bool squarish = box.width > 0.5 * box.length;
    if (squarish && b.score() > a.score()) return {crosswise, b};
    return {lengthwise, a};
  }

  [[nodiscard]] Sides sides_of(const Candidate& door, double reach) const {
    const Vec2 n = perpendicular(door.along);
    return {looker_.look(door, n, reach), looker_.look(door, -n, reach)};
  }

  // A line or a point: taken where it stands when there is a wall, else moved onto the nearest wall of its cell.
  bool from_path(const PlanDoor& door, Candidate& candidate, Sides& sides) {
    const Vec2 given = 0.5 * (door.path.front() + door.path.back());
    if (door.path.size() == 2 && distance(door.path[0], door.path[1]) > kMinWidth) {
      const Vec2 chord = door.path[1] - door.path[0];
      candidate = {given, (1.0 / norm(chord)) * chord, norm(chord), 0.0};
      sides = sides_of(candidate, kWallReach);
      if (joins_two(sides)) return true;
    }
    const auto snapped = snap(door, given, candidate.width);
    if (!snapped) {
      unresolved(door, given, "stands off every wall: left out");
      return false;
    }
    const double moved = distance(snapped->first.centre, given);
    std::tie(candidate, sides) = *snapped;
    if (moved > 0.05 && report_ != nullptr) {
      char text[80];
      std::snprintf(text, sizeof text, "stood %.2f m off its wall: moved onto it", moved);
      report_->repaired(door.source, floor_.plan->short_name, candidate.centre, text);
    }
    return true;
  }

  static bool joins_two(const Sides& sides) {
    if (sides.front.kind == Side::Kind::blocked || sides.back.kind == Side::Kind::blocked) return false;
    if (sides.front.kind == Side::Kind::outside && sides.back.kind == Side::Kind::outside) return false;
    return sides.front.kind != sides.back.kind || sides.front.cell != sides.back.cell;
  }

  // The point of the nearest cell's outline, in the middle between it and the next cell if there is a wall between.
  std::optional<std::pair<Candidate, Sides>> snap(const PlanDoor& door, Vec2 given, double line_width) const {
    const double width = door.width > 0.0 ? door.width : line_width > kMinWidth ? line_width : kDefaultWidth;
    std::optional<std::pair<Candidate, Sides>> best;
    int best_score = 0;
    double best_distance = kSnapReach;
    for (const Cell& cell : floor_.cells) {
      if (geos::distance(geos::boundary(cell.floor), given) > kSnapReach) continue;
      for (const Path& ring : geos::to_paths(geos::boundary(cell.floor))) {
        for (std::size_t i = 1; i < ring.size(); ++i) {
          const Segment edge{ring[i - 1], ring[i]};
          const double away = distance(edge, given);
          const bool curved = edge.length() < kMinWidth && curves(ring, i);
          if (away > kSnapReach || (edge.length() < kMinWidth && !curved)) continue;
          const Candidate here{nearest_point(edge, given), (1.0 / edge.length()) * edge.direction(), width, 0.0};
          // Beside its tangent point a curved wall is not where a straight one would be.
          Candidate looked_at = here;
          if (curved) looked_at.width = edge.length();
          const Sides sides = sides_of(looked_at, kWallReach);
          const int score = joins_two(sides) ? 10 + sides.score() : 0;
          if (score > 0 && (score > best_score || (score == best_score && away < best_distance - 1e-6))) {
            best = {here, sides};
            best_score = score;
            best_distance = away;
          }
        }
      }
    }
    return best;
  }

  // Whether the ring (whose last point is its first) goes on without a corner before and behind its i-th edge.
  static bool curves(const Path& ring, std::size_t i) {
    const std::size_t edges = ring.size() - 1;
    const auto direction = [&](std::size_t edge) {
      const Vec2 d = ring[edge % edges + 1] - ring[edge % edges];
      return (1.0 / norm(d)) * d;
    };
    const Vec2 here = direction(i - 1);
    return dot(here, direction(i - 1 + edges - 1)) > kCurve && dot(here, direction(i)) > kCurve;
  }

  void keep(const PlanDoor& door, const Candidate& candidate, const Sides& sides) {
    if (!joins_two(sides)) {
      const bool wall = sides.front.kind == Side::Kind::cell || sides.back.kind == Side::Kind::cell;
      unresolved(door, candidate.centre, wall ? "leads into a wall or a space without a room: left out"
                                              : "has no room on either side: left out");
      return;
    }
    PlacedDoor placed{door.source, door.name, candidate.centre, candidate.along,
                      door.width > 0.0 && door.area.empty() ? door.width : candidate.width,
                      sides.front.cell, sides.back.cell, sides.front.distance, sides.back.distance,
                      door.area.empty() ? Shape() : shape_of(door.area)};
    const bool exit = placed.front < 0 || placed.back < 0;
    if (placed.front < 0) {  // the cell is always in front
      std::swap(placed.front, placed.back);
      std::swap(placed.to_front, placed.to_back);
      placed.along = -placed.along;
    }
    if (!exit) {
      placement_.doors.push_back(placed);
    } else if (door.way_out == PlanDoor::WayOut::yes || floor_.plan->ground) {
      placement_.exits.push_back(placed);
    } else {
      unresolved(door, candidate.centre, "leads outdoors above or below the ground: not taken for a way out");
    }
  }

  void unresolved(const PlanDoor& door, Vec2 at, const char* what) {
    if (report_ != nullptr) report_->unresolved(door.source, floor_.plan->short_name, at, std::string("door ") + what);
  }

  // Two leaves side by side in the same wall are one door.
  void join_leaves(std::vector<PlacedDoor>& doors) {
    for (std::size_t i = 0; i < doors.size(); ++i) {
      for (std::size_t j = i + 1; j < doors.size();) {
        if (is_leaf_of(doors[i], doors[j])) {
          absorb(doors[i], doors[j]);
          doors.erase(doors.begin() + static_cast<std::ptrdiff_t>(j));
          j = i + 1;
        } else {
          ++j;
        }
      }
    }
  }

  static bool is_leaf_of(const PlacedDoor& a, const PlacedDoor& b) {
    const bool same_cells = (a.front == b.front && a.back == b.back) || (a.front == b.back && a.back == b.front);
    const Vec2 d = b.centre - a.centre;
    return same_cells && std::abs(cross(a.along, b.along)) < 0.2 && std::abs(dot(d, perpendicular(a.along))) < 0.2 &&
           std::abs(dot(d, a.along)) < 0.5 * (a.width + b.width) + kLeafGap;
  }

  void absorb(PlacedDoor& a, const PlacedDoor& b) {
    const double offset = dot(b.centre - a.centre, a.along);
    const double low = std::min(-0.5 * a.width, offset - 0.5 * b.width);
    const double high = std::max(0.5 * a.width, offset + 0.5 * b.width);
    a.centre = a.centre + (0.5 * (low + high)) * a.along;
    a.width = high - low;
    a.drawn = a.drawn.empty() || b.drawn.empty() ? Shape() : geos::unite({a.drawn, b.drawn});
    if (a.name.empty()) a.name = b.name;
    if (report_ != nullptr) {
      report_->note(b.source, floor_.plan->short_name, a.centre, "joined with " + a.source.id + ": leaves of one door");
    }
  }

  const LevelFloor& floor_;
  Looker looker_;
  Report* report_;
  DoorPlacement placement_;
};

}  // namespace

DoorPlacement place_doors(const LevelFloor& floor, Report* report) { return Placer(floor, report).place(); }

}  // namespace echoway::import
