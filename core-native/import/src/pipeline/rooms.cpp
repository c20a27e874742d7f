#include "pipeline/rooms.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "pipeline/names.hpp"

namespace echoway::import {
namespace {

constexpr double kHall = 50.0;          // square metres; a space this large is kept even if no door leads into it
constexpr int kMostRounds = 3;          // of opening doors that turn out to stand within one space
constexpr const char* kCorridor = "Corridor";
constexpr double kReadingRow = 2.0;     // metres; rooms whose middles are this near in y stand in one row

LevelRooms cut_and_place(const PlanLevel& level, Report& report) {
  std::set<std::size_t> open;
  for (int round = 0; round < kMostRounds; ++round) {
    const LevelFloor floor = cut_floor(level, open, nullptr);
    const std::set<std::size_t> within = place_doors(floor, nullptr).within_a_cell;
    const std::size_t before = open.size();
    open.insert(within.begin(), within.end());
    if (open.size() == before) break;
  }
  for (const std::size_t i : open) {
    const PlanDoor& door = level.doors[i];
    report.note(door.source, level.short_name, geos::oriented_box(shape_of(door.area)).centre,
                "door stands within one space: taken as an open passage");
  }
  LevelRooms rooms;
  rooms.floor = cut_floor(level, open, &report);
  DoorPlacement placement = place_doors(rooms.floor, &report);
  std::erase_if(placement.doors, [](const PlacedDoor& d) { return d.front == d.back; });
  rooms.doors = std::move(placement.doors);
  rooms.exits = std::move(placement.exits);
  return rooms;
}

// Keeps the cells for which `keep` holds and renumbers them in `order`.
void renumber(LevelRooms& rooms, const std::vector<std::size_t>& order) {
  std::vector<int> now(rooms.floor.cells.size(), PlacedDoor::kOutside);
  std::vector<Cell> cells;
  for (const std::size_t old : order) {
    now[old] = static_cast<int>(cells.size());
    cells.push_back(std::move(rooms.floor.cells[old]));
  }
  rooms.floor.cells = std::move(cells);
  for (auto* doors : {&rooms.doors, &rooms.exits}) {
    for (PlacedDoor& door : *doors) {
      if (door.front >= 0) door.front = now[static_cast<std::size_t>(door.front)];
      if (door.back >= 0) door.back = now[static_cast<std::size_t>(door.back)];
    }
  }
  std::erase_if(rooms.doors, [](const PlacedDoor& d) { return d.front < 0 || d.back < 0; });
  std::erase_if(rooms.exits, [](const PlacedDoor& d) { return d.front < 0; });
}

// Rooms that the plan draws, and spaces that stairs or an elevator lead into, are there whatever their doors.
bool is_a_place(const Cell& cell) {
  const auto counts = [](const PlanUnit* unit) {
    return unit->kind == UnitKind::room || unit->kind == UnitKind::stairs || unit->kind == UnitKind::elevator;
  };
  return (cell.unit != nullptr && counts(cell.unit)) || std::any_of(cell.contains.begin(), cell.contains.end(), counts);
}

// A space that the plan neither names nor gives a door is a shaft or a void in the construction.
void leave_out_shafts(LevelRooms& rooms, Report& report) {
  std::vector<bool> has_door(rooms.floor.cells.size(), false);
  for (const auto* doors : {&rooms.doors, &rooms.exits}) {
    for (const PlacedDoor& door : *doors) {
      if (door.front >= 0) has_door[static_cast<std::size_t>(door.front)] = true;
      if (door.back >= 0) has_door[static_cast<std::size_t>(door.back)] = true;
    }
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rooms.floor.cells.size(); ++i) {
    const Cell& cell = rooms.floor.cells[i];
    const double area = cell.floor.area();
    if (has_door[i] || area > kHall) {
      kept.push_back(i);
      continue;
    }
    const Source source = cell.unit != nullptr ? cell.unit->source : Source{rooms.floor.plan->file, ""};
    char text[120];
    const bool keep = is_a_place(cell);
    std::snprintf(text, sizeof text, "no door leads into this space of %.1f m2: %s", area,
                  keep ? "kept, but nobody can be led through a door" : "left out");
    report.unresolved(source, rooms.floor.plan->short_name, geos::inscribed_circle(cell.floor).centre, text);
    if (keep) kept.push_back(i);
  }
  renumber(rooms, kept);
}

void sort_for_reading(LevelRooms& rooms) {
  std::vector<Vec2> middle;
  for (const Cell& cell : rooms.floor.cells) middle.push_back(geos::inscribed_circle(cell.floor).centre);
  std::vector<std::size_t> order(middle.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return std::pair(-std::round(middle[i].y / kReadingRow), middle[i].x); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  renumber(rooms, order);
}

// A pathway names the space through which most of it leads, if that has no name yet. "path to stairs" tells where it
// goes, not what a space is called.
std::vector<std::string> names_from_pathways(const LevelFloor& floor) {
  std::vector<std::map<std::string, double>> metres(floor.cells.size());
  for (const PlanPathway& pathway : floor.plan->pathways) {
    const std::string name = clean_name(pathway.name);
    if (pathway.entrance || name.empty() || pathway.path.size() < 2 || slug(name).starts_with("path")) continue;
    const geos::Shape line = geos::line(pathway.path);
    std::size_t best = floor.cells.size();
    double most = 0.0;
    for (std::size_t i = 0; i < floor.cells.size(); ++i) {
      const double inside = geos::intersection(line, floor.cells[i].floor).length();
      if (inside > most) {
        most = inside;
        best = i;
      }
    }
    if (best < floor.cells.size()) metres[best][name] += most;
  }
  std::vector<std::string> names(floor.cells.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    double most = 0.0;
    for (const auto& [name, length] : metres[i]) {
      if (length > most) {
        most = length;
        names[i] = name;
      }
    }
  }
  return names;
}

std::string name_of(const PlanUnit& unit) {
  std::string name = clean_name(unit.name);
  if (!name.empty()) return name;
  if (!unit.number.empty()) {
    const std::string kind = spoken_category(unit.category);
    return clean_name((kind.empty() ? "Room" : kind) + " " + unit.number);
  }
  return spoken_category(unit.category);
}

// A long space with doors to several others, that the plan does not name: what else would a visitor call it?
bool is_corridor(const LevelRooms& rooms, std::size_t cell) {
  constexpr int kManyDoors = 4;
  constexpr double kLong = 28.0;      // perimeter squared over area: a rectangle five times as long as wide
  constexpr double kHalfWidth = 2.0;  // metres
  const auto joins = [cell](const PlacedDoor& d) {
    return d.front == static_cast<int>(cell) || d.back == static_cast<int>(cell);
  };
  const geos::Shape floor = geos::fill_holes(rooms.floor.cells[cell].floor);
  return std::count_if(rooms.doors.begin(), rooms.doors.end(), joins) >= kManyDoors &&
         floor.length() * floor.length() > kLong * floor.area() &&
         geos::inscribed_circle(floor).radius < kHalfWidth;
}

void name_cells(LevelRooms& rooms) {
  const std::vector<std::string> pathways = names_from_pathways(rooms.floor);
  for (std::size_t i = 0; i < rooms.floor.cells.size(); ++i) {
    const Cell& cell = rooms.floor.cells[i];
    std::string name = cell.unit != nullptr ? clean_name(cell.unit->name) : "";
    if (name.empty()) name = pathways[i];
    if (name.empty() && cell.unit != nullptr) name = name_of(*cell.unit);
    const bool inferred = name.empty() && is_corridor(rooms, i);
    rooms.names.push_back(inferred ? kCorridor : std::move(name));
    rooms.is_destination.push_back(!inferred && !rooms.names.back().empty());
  }
}

}  // namespace

LevelRooms find_rooms(const PlanLevel& level, Report& report) {
  LevelRooms rooms = cut_and_place(level, report);
  leave_out_shafts(rooms, report);
  sort_for_reading(rooms);
  name_cells(rooms);
  return rooms;
}

}  // namespace echoway::import
