#include "pipeline/floor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "pipeline/gaps.hpp"
#include "pipeline/units.hpp"

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kCrevice = 0.035;       // metres; half the width of crevices in walls that are smoothed away
constexpr double kMinRoomArea = 0.5;     // square metres; less is a shaft or a sliver
constexpr double kMinRoomRadius = 0.25;  // metres; nobody fits into less
constexpr double kExposed = 0.8;         // metres of a cell's border on the outline, without a wall: it is outdoors
constexpr double kOutlineBand = 0.06;    // metres around the outline in which a border counts as lying on it

std::string metres_text(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2f %s", value, unit);
  return text;
}

Shape wall_shape(const PlanWall& wall) {
  if (wall.path.size() < 2) return shape_of(wall.area);
  // A wall drawn as a ring of lines is the band along it.
  return geos::thicken(wall.path, wall.thickness);
}

Shape units_of(const PlanLevel& level, std::initializer_list<UnitKind> kinds) {
  std::vector<Shape> shapes;
  for (const PlanUnit& unit : level.units) {
    if (std::find(kinds.begin(), kinds.end(), unit.kind) != kinds.end()) shapes.push_back(shape_of(unit.area));
  }
  return geos::unite(shapes);
}

// The parts of `area` that are wider than twice `radius`, with their corners.
Shape without_crevices(const Shape& area, double radius) {
  return geos::intersection(geos::grow(geos::grow(area, -radius), radius), area);
}

bool fits_a_person(const Shape& area) {
  return area.area() >= kMinRoomArea && geos::inscribed_circle(area).radius >= kMinRoomRadius;
}

// A cell that reaches the outline without a wall between is open to the outside: an arcade, a covered passage. A unit
// there (a balcony) says that it is a place all the same.
bool is_exposed(const Shape& cell, const Shape& outline_band) {
  return geos::intersection(geos::boundary(cell), outline_band).length() > kExposed;
}

class Cutter {
 public:
  Cutter(const PlanLevel& level, Report* report) : level_(level), report_(report) { floor_.plan = &level; }

  LevelFloor cut(const std::set<std::size_t>& open_doors) {
    collect_barriers(open_doors);
    const Shape free = geos::difference(geos::difference(floor_.inside, barrier_), given_outdoors_);
    std::vector<Cell> cells;
    for (const Shape& part : geos::areas(free)) {
      const Shape smooth = without_crevices(part, kCrevice);
      for (const Shape& piece : geos::areas(smooth)) cells.push_back({piece, nullptr, {}, {}});
    }
    cells = cut_out_units(level_, std::move(cells), report_);
    keep_rooms(std::move(cells));
    attach_units(level_, floor_.cells);
    leave_out_the_outdoors();
    for (Cell& cell : floor_.cells) cell.bounds = geos::bounds(cell.floor);
    return std::move(floor_);
  }

 private:
  void collect_barriers(const std::set<std::size_t>& open_doors) {
    std::vector<BarrierPart> parts;
    std::vector<Shape> solids, barriers;
    const auto add = [&](Shape shape, const Source& source, bool solid) {
      if (solid) solids.push_back(shape);
      barriers.push_back(shape);
      parts.push_back({std::move(shape), source});
    };
    for (const PlanWall& wall : level_.walls) add(wall_shape(wall), wall.source, true);
    for (const PlanUnit& unit : level_.units) {
      if (unit.kind == UnitKind::solid || unit.kind == UnitKind::opening) add(shape_of(unit.area), unit.source, true);
    }
    for (std::size_t i = 0; i < level_.doors.size(); ++i) {
      const PlanDoor& door = level_.doors[i];
      if (!door.area.empty() && open_doors.count(i) == 0) add(shape_of(door.area), door.source, false);
    }
    floor_.solids = geos::unite(solids);
    given_outdoors_ = units_of(level_, {UnitKind::outdoors});
    const Shape all = geos::unite(barriers);
    floor_.inside = inside(all);
    barrier_ = close_gaps(all, parts, floor_.inside, level_.short_name, report_);
  }

  Shape inside(const Shape& barriers) const {
    if (!level_.outline.empty()) return shape_of(level_.outline);
    const Shape units = units_of(level_, {UnitKind::room, UnitKind::open, UnitKind::zone, UnitKind::stairs,
                                          UnitKind::elevator});
    return geos::unite({units, geos::fill_holes(barriers)});
  }

  void keep_rooms(std::vector<Cell> cells) {
    for (Cell& cell : cells) {
      if (fits_a_person(cell.floor)) {
        floor_.cells.push_back(std::move(cell));
      } else if (report_ != nullptr && cell.floor.area() > 0.01) {
        report_->repaired(cell.unit != nullptr ? cell.unit->source : Source{level_.file, ""}, level_.short_name,
                          geos::to_polygon(cell.floor).outer.front(),
                          "a sliver of " + metres_text(cell.floor.area(), "m2") + " between walls is no room: filled");
      }
    }
  }

  void leave_out_the_outdoors() {
    std::vector<Shape> outdoors{given_outdoors_};
    if (!level_.outline.empty()) {
      std::vector<Shape> bands;
      for (Path ring : geos::to_paths(geos::boundary(floor_.inside))) {
        bands.push_back(geos::thicken(ring, kOutlineBand));
      }
      const Shape band = geos::unite(bands);
      std::erase_if(floor_.cells, [&](const Cell& cell) {
        const bool out = cell.unit == nullptr && is_exposed(cell.floor, band);
        if (out) outdoors.push_back(cell.floor);
        return out;
      });
    }
    floor_.outdoors = geos::unite(outdoors);
  }

  const PlanLevel& level_;
  Report* report_;
  LevelFloor floor_;
  Shape barrier_, given_outdoors_;
};

}  // namespace

int LevelFloor::cell_at(Vec2 p) const {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].bounds.contain(p) && geos::contains(cells[i].floor, p)) return static_cast<int>(i);
  }
  return -1;
}

int LevelFloor::cell_near(Vec2 p, double reach) const {
  int nearest = -1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double d = geos::distance(cells[i].floor, p);
    if (d <= reach) {
      reach = d;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

LevelFloor cut_floor(const PlanLevel& level, const std::set<std::size_t>& open_doors, Report* report) {
  return Cutter(level, report).cut(open_doors);
}

Shape shape_of(const Area& area) {
  std::vector<Shape> parts;
  for (const geos::Polygon2& polygon : area) parts.push_back(geos::area_of(polygon));
  return parts.size() == 1 ? parts.front() : geos::unite(parts);
}

}  // namespace echoway::import
