#include "pipeline/doors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <tuple>

#include "echoway/geometry/segment.hpp"
#include "echoway/units.hpp"
#include "pipeline/door_sides.hpp"

namespace echoway::import {
namespace {

using geos::Shape;
using Kind = DoorSide::Kind;

constexpr double kDefaultWidth = feet(3.0);  // when the plan gives a point only (as in the building format)
constexpr double kFrameReach = 0.35;     // metres to look for floor from the face of a door drawn as an area
constexpr double kSnapReach = 0.75;      // metres by which a door may stand off its wall
constexpr double kOnWall = 0.05;         // metres from its wall within which it stands on it
constexpr double kMinWidth = 0.4;        // metres
constexpr double kCurve = 0.7;           // cosine of the turn up to which short edges are pieces of one curved wall
constexpr double kLeafGap = 0.15;        // metres between leaves of one door
constexpr double kSameWall = 0.2;        // metres across the wall between leaves of one door

constexpr const char* kLeadsNowhere = "leads into a wall or a space without a room: left out";

// How well a door stands somewhere: what joins two rooms is more of a door than what leads out of one, unless the plan
// says that it leads out.
int worth(const DoorSides& sides, bool way_out) {
  const auto of_side = [way_out](const DoorSide& side) {
    if (side.kind == Kind::cell) return 2;
    if (side.kind == Kind::blocked) return 0;
    return way_out ? 3 : 1;
  };
  return of_side(sides.front) + of_side(sides.back) - (sides.within_one_cell() ? 2 : 0);
}

// A place on a wall where a door may be.
struct DoorPlace {
  DoorCandidate candidate;
  DoorSides sides;
  double away = 0.0;  ///< Metres from where the plan has it.
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
    const auto place = door.area.empty() ? from_path(door) : from_area(door);
    if (!place) {
      return unresolved(door, middle_of(door), beside_a_wall(middle_of(door)) ? kLeadsNowhere
                                                                              : "stands off every wall: left out");
    }
    if (place->sides.within_one_cell()) {
      if (!door.area.empty()) {
        placement_.within_a_cell.insert(index);
      } else {
        unresolved(door, place->candidate.centre, "has the same room on both sides: left out");
      }
      return;
    }
    keep(door, place->candidate, place->sides);
  }

  // The wall runs along the side of the door's rectangle across which there is floor on both sides; the longer one when
  // both do.
  std::optional<DoorPlace> from_area(const PlanDoor& door) const {
    const geos::Box box = geos::oriented_box(shape_of(door.area));
    const DoorCandidate lengthwise{box.centre, box.along, box.length, 0.5 * box.width};
    const DoorCandidate crosswise{box.centre, perpendicular(box.along), box.width, 0.5 * box.length};
    const DoorSides a = looker_.within(lengthwise, lengthwise.half_depth + kFrameReach);
    const DoorSides b = looker_.within(crosswise, crosswise.half_depth + kFrameReach);
    const bool squarish = box.width > 0.5 * box.length;
    if (squarish && worth(b, door.way_out) > worth(a, door.way_out)) return DoorPlace{crosswise, b, 0.0};
    return DoorPlace{lengthwise, a, 0.0};
  }

  // REQUIRES: a door with a path.
  static Vec2 middle_of(const PlanDoor& door) { return 0.5 * (door.path.front() + door.path.back()); }

  // A line or a point: taken where it stands when there is a wall, else moved onto the best one near by.
  std::optional<DoorPlace> from_path(const PlanDoor& door) const {
    const Vec2 chord = door.path.back() - door.path.front();
    if (norm(chord) > kMinWidth) {
      const DoorCandidate drawn{middle_of(door), (1.0 / norm(chord)) * chord, norm(chord), 0.0};
      const DoorSides sides = sides_of(drawn, door);
      if (sides.joins_two()) return DoorPlace{drawn, sides, 0.0};
    }
    const auto snapped = snap(door, norm(chord));
    if (snapped && snapped->away > kOnWall && report_ != nullptr) {
      char text[80];
      std::snprintf(text, sizeof text, "stood %.2f m off its wall: moved onto it", snapped->away);
      report_->repaired(door.source, floor_.plan->short_name, snapped->candidate.centre, text);
    }
    return snapped;
  }

  // What the plan calls a way out does not lead into the building across the way.
  DoorSides sides_of(const DoorCandidate& candidate, const PlanDoor& door) const {
    return door.way_out ? looker_.within(candidate, DoorLooker::kWallReach) : looker_.through_wall(candidate);
  }

  // The best point on a cell's outline.
  std::optional<DoorPlace> snap(const PlanDoor& door, double line_width) const {
    const Vec2 given = middle_of(door);
    const double width = door.width > 0.0 ? door.width : line_width > kMinWidth ? line_width : kDefaultWidth;
    std::optional<DoorPlace> best;
    for (const Cell& cell : floor_.cells) {
      if (geos::distance(geos::boundary(cell.floor), given) > kSnapReach) continue;
      for (const Path& ring : geos::to_paths(geos::boundary(cell.floor))) {
        for (std::size_t i = 1; i < ring.size(); ++i) {
          const Segment edge{ring[i - 1], ring[i]};
          const double away = distance(edge, given);
          const bool curved = edge.length() < kMinWidth && curves(ring, i);
          if (away > kSnapReach || (edge.length() < kMinWidth && !curved)) continue;
          const DoorCandidate here{nearest_point(edge, given), (1.0 / edge.length()) * edge.direction(), width, 0.0};
          // Beside its tangent point a curved wall is not where a straight one would be.
          DoorCandidate looked_at = here;
          if (curved) looked_at.width = edge.length();
          const DoorPlace place{here, sides_of(looked_at, door), away};
          if (place.sides.joins_two() && (!best || better(place, *best, door))) best = place;
        }
      }
    }
    return best;
  }

  [[nodiscard]] bool beside_a_wall(Vec2 p) const {
    return std::any_of(floor_.cells.begin(), floor_.cells.end(), [p](const Cell& cell) {
      return geos::distance(geos::boundary(cell.floor), p) <= kSnapReach;
    });
  }

  // The wall that a door stands on is before others near by: an entrance beside a partition does not lead through that.
  static bool better(const DoorPlace& a, const DoorPlace& b, const PlanDoor& door) {
    const bool a_on_wall = a.away <= kOnWall, b_on_wall = b.away <= kOnWall;
    if (a_on_wall != b_on_wall) return a_on_wall;
    const int a_worth = worth(a.sides, door.way_out), b_worth = worth(b.sides, door.way_out);
    return a_worth != b_worth ? a_worth > b_worth : a.away < b.away - 1e-6;
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

  void keep(const PlanDoor& door, const DoorCandidate& candidate, const DoorSides& sides) {
    if (!sides.joins_two()) {
      unresolved(door, candidate.centre,
                 sides.has(Kind::cell) ? kLeadsNowhere : "has no room on either side: left out");
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
    } else if (door.way_out || (floor_.plan->ground && !sides.has(Kind::court))) {
      placement_.exits.push_back(placed);
    } else {
      unresolved(door, candidate.centre,
                 sides.has(Kind::court) ? "leads into a court or a space that is not drawn: not taken for a way out"
                                        : "leads outdoors above or below the ground: not taken for a way out");
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
    const Vec2 d = middle_of(b) - middle_of(a);
    return same_cells && std::abs(cross(a.along, b.along)) < 0.2 &&
           std::abs(dot(d, perpendicular(a.along))) < kSameWall &&
           std::abs(dot(d, a.along)) < 0.5 * (a.width + b.width) + kLeafGap;
  }

  // In the middle of the wall: a plan may draw the same door on both faces of it.
  static Vec2 middle_of(const PlacedDoor& door) {
    if (door.back == PlacedDoor::kOutside) return door.centre;
    return door.centre + 0.5 * (door.to_front - door.to_back) * perpendicular(door.along);
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
  DoorLooker looker_;
  Report* report_;
  DoorPlacement placement_;
};

}  // namespace

DoorPlacement place_doors(const LevelFloor& floor, Report* report) { return Placer(floor, report).place(); }

}  // namespace echoway::import
