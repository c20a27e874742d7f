#include "pipeline/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "pipeline/doorways.hpp"
#include "pipeline/names.hpp"

namespace echoway::import {
namespace {

using geos::Shape;

constexpr double kAmenityReach = 1.5;      // metres from an amenity to the floor it is served from
constexpr double kEntranceReach = 3.0;     // metres from an entrance path to the door that it goes through
constexpr double kSamePlace = 3.0;         // metres; equal names nearer than this are one place

class Assembler {
 public:
  Assembler(const Plan& plan, const std::vector<LevelRooms>& levels, Report& report)
      : levels_(levels), report_(report) {
    building_.name = clean_name(plan.name);
    building_.unit = LengthUnit::metres;
  }

  Building run(const std::vector<PlacedLink>& links) {
    for (std::size_t i = 0; i < levels_.size(); ++i) add_level(i);
    for (const PlacedLink& link : links) {
      const RoomIndex a = room_at(link.level_a, link.cell_a), b = room_at(link.level_b, link.cell_b);
      building_.links.push_back({link.kind, a, local(a, link.at_a), b, local(b, link.at_b)});
    }
    tell_places_apart();
    return std::move(building_);
  }

 private:
  RoomIndex room_at(std::size_t level, int cell) const { return first_room_[level] + cell; }
  Vec2 local(RoomIndex room, Vec2 at) const { return building_.room(room).frame.inverse_transform(at); }

  void add_level(std::size_t index) {
    const LevelRooms& rooms = levels_[index];
    first_room_.push_back(static_cast<RoomIndex>(building_.rooms.size()));
    std::vector<Shape> floors;
    for (const Cell& cell : rooms.floor.cells) floors.push_back(cell.floor);
    const std::vector<DoorSite> sites = open_doorways(floors, rooms.doors);
    for (std::size_t i = 0; i < floors.size(); ++i) add_room(rooms, i, floors[i]);
    for (std::size_t i = 0; i < rooms.doors.size(); ++i) add_door(index, rooms.doors[i], sites[i]);
    for (const PlacedDoor& exit : rooms.exits) add_exit(index, exit, floors);
    add_furniture(index, floors);
    add_places(index, floors);
  }

  std::string id_of(const LevelRooms& rooms, std::size_t cell) {
    std::string wanted = slug(rooms.names[cell]);
    if (wanted.empty()) wanted = "room";
    const std::string level = slug(rooms.floor.plan->short_name);
    if (!level.empty()) wanted = level + "-" + wanted;
    // Spaces without a name are counted from one, in reading order; equal names from the second.
    if (rooms.names[cell].empty()) wanted += "-" + std::to_string(++unnamed_[rooms.floor.plan->ordinal]);
    return unique_id(wanted, ids_);
  }

  void add_room(const LevelRooms& rooms, std::size_t cell, const Shape& floor) {
    const geos::Polygon2 polygon = geos::to_polygon(floor);
    Room room;
    room.id = id_of(rooms, cell);
    room.name = rooms.names[cell];
    room.level = rooms.floor.plan->ordinal;
    Vec2 low = polygon.outer.front();
    for (const Vec2 p : polygon.outer) low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    room.frame.position = {std::floor(low.x * 100.0) / 100.0, std::floor(low.y * 100.0) / 100.0};
    add_walls(room, polygon.outer);
    for (const Path& hole : polygon.holes) add_walls(room, hole);
    building_.rooms.push_back(std::move(room));
  }

  static void add_walls(Room& room, const Path& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      room.walls.push_back({room.frame.inverse_transform(ring[i]),
                            room.frame.inverse_transform(ring[(i + 1) % ring.size()])});
    }
  }

  void add_door(std::size_t level, const PlacedDoor& door, const DoorSite& site) {
    const RoomIndex a = room_at(level, door.front), b = room_at(level, door.back);
    building_.doors.push_back({a, local(a, site.at), b, local(b, site.at), site.width});
  }

  void add_exit(std::size_t level, const PlacedDoor& exit, const std::vector<Shape>& floors) {
    const RoomIndex room = room_at(level, exit.front);
    const Shape border = geos::boundary(floors[static_cast<std::size_t>(exit.front)]);
    const Vec2 at = geos::nearest_on(border, exit.centre + exit.to_front * perpendicular(exit.along));
    std::string name = clean_name(exit.name);
    for (const PlanPathway& pathway : levels_[level].floor.plan->pathways) {
      if (name.empty() && pathway.entrance && geos::distance(geos::line(pathway.path), at) < kEntranceReach) {
        name = clean_name(pathway.name);
      }
    }
    building_.exits.push_back({room, local(room, at), name});
  }

  void add_furniture(std::size_t level, const std::vector<Shape>& floors) {
    const PlanLevel& plan = *levels_[level].floor.plan;
    for (const PlanFurniture& piece : plan.furniture) {
      const Shape outline = piece.area.empty() ? geos::line(piece.path) : geos::boundary(shape_of(piece.area));
      bool placed = false;
      for (std::size_t i = 0; i < floors.size(); ++i) {
        if (!geos::intersects(floors[i], outline)) continue;
        placed = true;
        Room& room = building_.rooms[static_cast<std::size_t>(first_room_[level]) + i];
        for (const Path& path : geos::to_paths(geos::intersection(outline, floors[i]))) {
          for (std::size_t k = 1; k < path.size(); ++k) {
            room.reflectors.push_back(
                {room.frame.inverse_transform(path[k - 1]), room.frame.inverse_transform(path[k])});
          }
        }
      }
      if (!placed) report_.unresolved(piece.source, plan.short_name, {}, "furniture in no room: left out");
    }
  }

  void add_places(std::size_t level, const std::vector<Shape>& floors) {
    const LevelRooms& rooms = levels_[level];
    for (std::size_t i = 0; i < floors.size(); ++i) {
      if (rooms.is_destination[i]) {
        add_place(room_at(level, static_cast<int>(i)), geos::inscribed_circle(floors[i]).centre, rooms.names[i]);
      }
      for (const PlanUnit* unit : rooms.floor.cells[i].contains) add_unit_place(level, i, *unit, floors[i]);
    }
    for (const PlanAmenity& amenity : rooms.floor.plan->amenities) add_amenity(level, amenity, floors);
  }

  void add_unit_place(std::size_t level, std::size_t cell, const PlanUnit& unit, const Shape& floor) {
    std::string name = clean_name(unit.name);
    if (name.empty()) name = spoken_category(unit.category);
    const std::vector<Shape> parts = geos::areas(geos::intersection(floor, shape_of(unit.area)));
    if (name.empty() || parts.empty()) return;
    const Shape& main = *std::max_element(parts.begin(), parts.end(),
                                          [](const Shape& a, const Shape& b) { return a.area() < b.area(); });
    const RoomIndex room = room_at(level, static_cast<int>(cell));
    const Vec2 at = geos::inscribed_circle(main).centre;
    if (unit.kind == UnitKind::zone || unit.kind == UnitKind::room) {
      report_.note(unit.source, levels_[level].floor.plan->short_name, at,
                   "'" + name + "' has no walls of its own: a place in room " + building_.room(room).id);
    }
    add_place(room, at, name);
  }

  void add_amenity(std::size_t level, const PlanAmenity& amenity, const std::vector<Shape>& floors) {
    std::string name = clean_name(amenity.name);
    if (name.empty()) name = spoken_category(amenity.category);
    if (name.empty()) return;
    std::size_t nearest = floors.size();
    double reach = kAmenityReach;
    for (std::size_t i = 0; i < floors.size(); ++i) {
      const double away = geos::distance(floors[i], amenity.at);
      if (away < reach) {
        reach = away;
        nearest = i;
      }
    }
    if (nearest == floors.size()) {
      report_.unresolved(amenity.source, levels_[level].floor.plan->short_name, amenity.at,
                         "'" + name + "' stands in no room: left out");
      return;
    }
    add_place(room_at(level, static_cast<int>(nearest)), geos::standing_point(floors[nearest], amenity.at), name);
  }

  void add_place(RoomIndex room, Vec2 at, const std::string& name) {
    const Vec2 here = local(room, at);
    const bool known = std::any_of(building_.places.begin(), building_.places.end(), [&](const Landmark& place) {
      return place.room == room && place.name == name && distance(place.at, here) < kSamePlace;
    });
    if (!known) building_.places.push_back({room, here, name});
  }

  // Somebody who asks for "Toilet" should get one that they can tell from the others: equal names get their level, and
  // on the same level a number in reading order.
  void tell_places_apart() {
    std::map<std::string, std::set<int>> levels;
    std::map<std::pair<std::string, int>, int> on_level;
    for (const Landmark& place : building_.places) {
      const int level = building_.room(place.room).level;
      levels[place.name].insert(level);
      ++on_level[{place.name, level}];
    }
    std::map<std::pair<std::string, int>, int> count;
    for (Landmark& place : building_.places) {
      const std::string name = place.name;
      const int level = building_.room(place.room).level;
      if (on_level[{name, level}] > 1) place.name += " " + std::to_string(++count[{name, level}]);
      if (levels[name].size() > 1) place.name += ", " + level_name(level);
    }
  }

  std::string level_name(int ordinal) const {
    for (const LevelRooms& level : levels_) {
      if (level.floor.plan->ordinal != ordinal) continue;
      const std::string name = clean_name(level.floor.plan->name);
      return name.empty() ? "level " + clean_name(level.floor.plan->short_name) : name;
    }
    return "level " + std::to_string(ordinal);
  }

  const std::vector<LevelRooms>& levels_;
  Report& report_;
  Building building_;
  std::vector<RoomIndex> first_room_;
  std::set<std::string> ids_;
  std::map<int, int> unnamed_;
};

}  // namespace

Building assemble(const Plan& plan, const std::vector<LevelRooms>& levels, const std::vector<PlacedLink>& links,
                  Report& report) {
  return Assembler(plan, levels, report).run(links);
}

}  // namespace echoway::import
