#include "building/doors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "building/features.hpp"
#include "building/phrases.hpp"
#include "echoway/building/opening.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// A listed edge is this door's jamb when it is this near to where the jamb would be derived.
constexpr double kSameJamb = feet(0.5);

class DoorMerger {
 public:
  DoorMerger(Building& building, std::vector<DoorLines>& lines) : building_(building), lines_(lines) {}

  void add(Door door, const DoorSource& source, int line) {
    const bool swapped = door.room_a > door.room_b;
    if (swapped) {
      std::swap(door.room_a, door.room_b);
      std::swap(door.at_a, door.at_b);
    }
    std::optional<std::size_t> known = find(door);
    if (!known) {
      known = building_.doors.size();
      building_.doors.push_back(door);
      lines_.push_back({.line = line});
      grid_[cell(door, 0, 0)].push_back(*known);
    }
    const Door& merged = building_.doors[*known];
    DoorLines& about = lines_[*known];
    (swapped ? about.from_b : about.from_a) |= !source.keyword;
    about.keyword |= source.keyword;
    about.disagreement =
        std::max({about.disagreement, distance(merged.at_a, door.at_a), distance(merged.at_b, door.at_b)});
    if (source.width && *source.width > 0.0) {
      building_.doors[*known].width = *source.width;
      about.width_given = true;
    }
  }

 private:
  using Cell = std::tuple<RoomIndex, RoomIndex, std::int64_t, std::int64_t>;

  static Cell cell(const Door& door, int dx, int dy) {
    return {door.room_a, door.room_b, static_cast<std::int64_t>(std::floor(door.at_a.x / kSameDoor)) + dx,
            static_cast<std::int64_t>(std::floor(door.at_a.y / kSameDoor)) + dy};
  }

  [[nodiscard]] std::optional<std::size_t> find(const Door& door) const {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = grid_.find(cell(door, dx, dy));
        if (found == grid_.end()) continue;
        for (const std::size_t i : found->second) {
          const Door& other = building_.doors[i];
          if (distance(other.at_a, door.at_a) <= kSameDoor && distance(other.at_b, door.at_b) <= kSameDoor) return i;
        }
      }
    }
    return std::nullopt;
  }

  Building& building_;
  std::vector<DoorLines>& lines_;
  std::map<Cell, std::vector<std::size_t>> grid_;
};

/// Distance between the nearest edges on either side of the door on its wall.
std::optional<double> width_between_edges(const Room& room, Vec2 at) {
  const std::optional<DoorOpening> opening = find_opening(room, at, kDefaultDoorWidth);
  if (!opening) return std::nullopt;
  const Segment& wall = room.walls[opening->wall];
  const Vec2 along = (1.0 / wall.length()) * wall.direction();
  const double centre = dot(along, nearest_point(wall, at) - wall.a);
  double before = std::numeric_limits<double>::infinity();
  double behind = before;
  for (const Vec2 edge : room.edges) {
    if (distance(wall, edge) > kSnapDistance) continue;
    const double offset = dot(along, edge - wall.a) - centre;
    double& side = offset < 0.0 ? before : behind;
    side = std::min(side, std::abs(offset));
  }
  const double width = before + behind;
  if (!(width > kSnapDistance && width <= kWidestDoor)) return std::nullopt;
  return width;
}

std::optional<RoomIndex> look_up(const RoomsById& rooms, const std::string& id) {
  const auto found = rooms.find(id);
  if (found == rooms.end()) return std::nullopt;
  return found->second;
}

}  // namespace

std::vector<DoorLines> assemble_doors(const ConfigSource& config, const RoomsById& rooms, Building& building,
                                      Findings& findings) {
  std::vector<DoorLines> lines;
  DoorMerger merger(building, lines);
  for (const Located<DoorSource>& door : config.doors) {
    bool known = true;
    for (const PlaceSource* side : {&door.what.a, &door.what.b}) {
      if (look_up(rooms, side->room)) continue;
      known = false;
      findings.unusable(Kind::unknown_room, config.file, door.line,
                        "a door leads to room '" + side->room + "', which has no file room-" + side->room +
                            ".room; add the file or remove the door");
    }
    if (!known) continue;
    const RoomIndex a = *look_up(rooms, door.what.a.room);
    const RoomIndex b = *look_up(rooms, door.what.b.room);
    if (a == b) {
      findings.warn(Kind::door_lines, config.file, door.line,
                    "a door leads from room '" + door.what.a.room +
                        "' to itself and is left out; name the room on its other side");
      continue;
    }
    if (door.what.width && !(*door.what.width > 0.0)) {
      findings.warn(Kind::door_width, config.file, door.line,
                    "the door's width is not positive and is left out; write its clear width");
    }
    merger.add({a, door.what.a.at, b, door.what.b.at, kDefaultDoorWidth}, door.what, door.line);
  }
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    if (lines[i].width_given) continue;
    Door& door = building.doors[i];
    const auto at_a = width_between_edges(building.room(door.room_a), door.at_a);
    const auto at_b = width_between_edges(building.room(door.room_b), door.at_b);
    // Jambs on one side may belong to another door or window: the narrower pair is this door's.
    if (at_a || at_b) door.width = std::min(at_a.value_or(kWidestDoor), at_b.value_or(kWidestDoor));
  }
  return lines;
}

void add_door_jambs(Building& building) {
  const std::vector<std::vector<DoorOpening>> openings = find_openings(building);
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    Room& room = building.rooms[i];
    for (const DoorOpening& opening : openings[i]) {
      const Segment& wall = room.walls[opening.wall];
      for (const Vec2 jamb : {opening.span.a, opening.span.b}) {
        if (distance(jamb, wall.a) <= kSameFeature || distance(jamb, wall.b) <= kSameFeature) continue;
        const bool known = std::any_of(room.edges.begin(), room.edges.end(),
                                       [&](Vec2 edge) { return distance(edge, jamb) <= kSameJamb; });
        if (!known) room.edges.push_back(jamb);
      }
    }
  }
}

}  // namespace echoway
