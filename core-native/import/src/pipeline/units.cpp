#include "pipeline/units.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kStrip = 0.2;          // metres; half the width of strips beside a unit that are no floor of their own
constexpr double kMinPiece = 0.3;       // square metres of a unit in a cell, less does not count
constexpr double kReported = 0.05;      // square metres of overlap that are worth a line
constexpr double kDoorReach = 0.3;      // metres from a unit's outline within which a door belongs to it
constexpr double kAgreement = 0.5;      // intersection over union from which a cell is the unit
constexpr double kCovers = 0.7;         // of a cell's area: then the cell is the unit, whatever else the unit covers

bool touches_open_floor(const PlanLevel& level, const Shape& area) {
  return std::any_of(level.units.begin(), level.units.end(), [&](const PlanUnit& unit) {
    return (unit.kind == UnitKind::open) && geos::distance(shape_of(unit.area), area) < 0.05;
  });
}

bool has_door(const PlanLevel& level, const Shape& area) {
  const Shape outline = geos::boundary(area);
  return std::any_of(level.doors.begin(), level.doors.end(), [&](const PlanDoor& door) {
    return door.path.empty() ? geos::distance(outline, shape_of(door.area)) < kDoorReach
                             : geos::distance(outline, 0.5 * (door.path.front() + door.path.back())) < kDoorReach;
  });
}

// Rooms have walls. Stairs and elevators in a source of units have them when a door says so, or when there is no open
// floor to be part of; where walls are drawn (an outline is given), these bound them.
bool has_own_walls(const PlanLevel& level, const PlanUnit& unit, const Shape& area) {
  if (unit.kind == UnitKind::room) return true;
  if (unit.kind != UnitKind::stairs && unit.kind != UnitKind::elevator) return false;
  if (!level.outline.empty()) return false;
  return has_door(level, area) || !touches_open_floor(level, area);
}

Shape opened(const Shape& area, double radius) {
  return geos::intersection(geos::grow(geos::grow(area, -radius), radius), area);
}

struct WalledUnit {
  const PlanUnit* unit;
  Shape area;
};

std::vector<WalledUnit> walled_units(const PlanLevel& level) {
  std::vector<WalledUnit> units;
  for (const PlanUnit& unit : level.units) {
    Shape area = shape_of(unit.area);
    if (has_own_walls(level, unit, area)) units.push_back({&unit, std::move(area)});
  }
  std::stable_sort(units.begin(), units.end(),
                   [](const WalledUnit& a, const WalledUnit& b) { return a.area.area() < b.area.area(); });
  return units;
}

void report_overlaps(const PlanLevel& level, const std::vector<WalledUnit>& units, Report& report) {
  for (std::size_t i = 0; i < units.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!geos::intersects(units[i].area, units[j].area)) continue;
      const Shape common = geos::intersection(units[i].area, units[j].area);
      if (common.area() < kReported) continue;
      char text[160];
      std::snprintf(text, sizeof text, "overlaps unit %s by %.2f m2: the smaller unit keeps it",
                    units[j].unit->source.id.c_str(), common.area());
      report.repaired(units[i].unit->source, level.short_name, geos::inscribed_circle(geos::areas(common)[0]).centre,
                      text);
    }
  }
}

// Cuts `unit` out of `cell`. What is left of the cell is appended to `rest`, what becomes the unit's own to `own`.
void cut_out(const WalledUnit& unit, const Cell& cell, std::vector<Cell>& rest, std::vector<Shape>& own) {
  const Shape piece = geos::intersection(cell.floor, unit.area);
  const Shape remainder = geos::difference(cell.floor, unit.area);
  const Shape real = opened(remainder, kStrip);
  std::vector<Shape> mine{piece};
  std::vector<Shape> others = geos::areas(real);
  for (const Shape& strip : geos::areas(geos::difference(remainder, real))) {
    const Shape edge = geos::boundary(strip);
    const double beside_unit = geos::intersection(edge, geos::boundary(piece)).length();
    const double beside_rest = geos::intersection(edge, geos::boundary(real)).length();
    (beside_unit >= beside_rest ? mine : others).push_back(strip);
  }
  for (const Shape& part : geos::areas(geos::unite(others))) rest.push_back({part, nullptr, {}, {}});
  own.push_back(geos::unite(mine));
}

}  // namespace

std::vector<Cell> cut_out_units(const PlanLevel& level, std::vector<Cell> cells, Report* report) {
  const std::vector<WalledUnit> units = walled_units(level);
  if (report != nullptr) report_overlaps(level, units, *report);
  std::vector<Cell> done;
  for (const WalledUnit& unit : units) {
    std::vector<Cell> rest;
    std::vector<Shape> own;
    for (Cell& cell : cells) {
      if (geos::intersects(cell.floor, unit.area) &&
          geos::intersection(cell.floor, unit.area).area() > kMinPiece) {
        cut_out(unit, cell, rest, own);
      } else {
        rest.push_back(std::move(cell));
      }
    }
    for (const Shape& part : geos::areas(geos::unite(own))) done.push_back({part, unit.unit, {}, {}});
    cells = std::move(rest);
  }
  std::move(cells.begin(), cells.end(), std::back_inserter(done));
  return done;
}

void attach_units(const PlanLevel& level, std::vector<Cell>& cells) {
  std::vector<double> best(cells.size(), kAgreement);
  for (const PlanUnit& unit : level.units) {
    if (unit.kind == UnitKind::solid || unit.kind == UnitKind::opening || unit.kind == UnitKind::outdoors) continue;
    const Shape area = shape_of(unit.area);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].unit == &unit || !geos::intersects(cells[i].floor, area)) continue;
      const double common = geos::intersection(cells[i].floor, area).area();
      if (common < kMinPiece) continue;
      cells[i].contains.push_back(&unit);
      if (cells[i].unit != nullptr && best[i] == kAgreement) continue;  // cut out for a unit: that is what it is
      double agreement = common / (area.area() + cells[i].floor.area() - common);
      if (common > kCovers * cells[i].floor.area()) agreement = std::max(agreement, kCovers);
      if (agreement > best[i]) {
        best[i] = agreement;
        cells[i].unit = &unit;
      }
    }
  }
  // A corner of a neighbouring room that reaches in (an overlap) is no place in this one.
  std::set<const PlanUnit*> are_cells;
  for (const Cell& cell : cells) are_cells.insert(cell.unit);
  for (Cell& cell : cells) {
    std::erase_if(cell.contains, [&](const PlanUnit* unit) {
      return unit == cell.unit || (unit->kind == UnitKind::room && are_cells.count(unit) != 0);
    });
  }
}

}  // namespace echoway::import
