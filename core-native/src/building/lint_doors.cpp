#include <algorithm>
#include <cmath>
#include <limits>

#include "building/lint.hpp"
#include "building/phrases.hpp"
#include "echoway/building/opening.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// A door's position may be the middle of a wall of twice this thickness.
constexpr double kOffWall = feet(0.3) + kSamePoint;

/// Lines about one door may differ by rounding.
constexpr double kLinesAgree = kSnapDistance;

/// Walls of one door run the same way on both sides, within this.
const double kParallel = std::sin(degrees(10.0));

class DoorLint {
 public:
  DoorLint(const Assembly& assembly, Findings& findings)
      : assembly_(assembly), building_(assembly.building), phrases_(assembly.building.unit), findings_(findings) {}

  void run() {
    const bool both_ways = std::any_of(assembly_.door_lines.begin(), assembly_.door_lines.end(),
                                       [](const DoorLines& d) { return d.from_a && d.from_b; });
    for (std::size_t i = 0; i < building_.doors.size(); ++i) {
      const Door& door = building_.doors[i];
      lint_position(i, door.room_a, door.at_a);
      lint_position(i, door.room_b, door.at_b);
      lint_lines(i, both_ways);
      lint_width(i);
      lint_rooms_joined(i);
    }
    lint_neighbours();
  }

 private:
  void warn(Kind kind, std::size_t door, std::string message) {
    findings_.warn(kind, assembly_.source.config.file, assembly_.door_lines[door].line, std::move(message));
  }
  [[nodiscard]] const std::string& id(RoomIndex room) const { return building_.room(room).id; }
  [[nodiscard]] std::string name(const Door& door) const {
    return door_label(building_, door);
  }

  void lint_position(std::size_t door, RoomIndex room, Vec2 at) {
    double off = std::numeric_limits<double>::infinity();
    Vec2 foot{};
    for (const Segment& wall : building_.room(room).walls) {
      const Vec2 p = nearest_point(wall, at);
      if (distance(p, at) < off) {
        off = distance(p, at);
        foot = p;
      }
    }
    if (off <= kOffWall) return;
    std::string message =
        "the door stands " + phrases_.length(off) + " off the nearest wall of room '" + id(room) + "'";
    if (off > kDoorReach) message += " and opens none";
    warn(Kind::door_position, door,
         message + "; move it to " + phrases_.point(foot) + " in that room's frame, or correct the wall");
  }

  void lint_lines(std::size_t i, bool both_ways) {
    const Door& door = building_.doors[i];
    const DoorLines& lines = assembly_.door_lines[i];
    if (lines.disagreement > kLinesAgree) {
      warn(Kind::door_lines, i,
           "the lines about " + name(door) + " differ by " + phrases_.length(lines.disagreement) +
               "; the first counts, correct the others");
    }
    // Doors may all be listed once; where others are listed from both sides, a missing side is a slip.
    if (!both_ways || lines.keyword || lines.from_a == lines.from_b) return;
    const RoomIndex from = lines.from_a ? door.room_b : door.room_a;
    warn(Kind::door_lines, i,
         name(door) + " is one-sided: other doors are listed from both rooms; add its line from room '" + id(from) +
             "'");
  }

  void lint_width(std::size_t i) {
    const Door& door = building_.doors[i];
    const DoorLines& lines = assembly_.door_lines[i];
    if (!is_passable(door) || door.width > kWidestDoor) {
      const char* consequence = is_passable(door) ? "" : ", and nobody is led through";
      warn(Kind::door_width, i,
           name(door) + " is " + phrases_.length(door.width) + " wide" + consequence +
               "; write its clear width in the building's unit");
      return;
    }
    if (!lines.width_given) return;
    for (const auto& [room, at] : {std::pair{door.room_a, door.at_a}, std::pair{door.room_b, door.at_b}}) {
      const auto opening = find_opening(building_.room(room), at, door.width);
      if (!opening || opening->span.length() >= door.width - kLinesAgree) continue;
      warn(Kind::door_width, i,
           name(door) + " is wider than its wall in room '" + id(room) + "' leaves from its middle; correct its " +
               "width or its place");
    }
  }

  void lint_rooms_joined(std::size_t i) {
    const Door& door = building_.doors[i];
    const Room& a = building_.room(door.room_a);
    const Room& b = building_.room(door.room_b);
    if (a.level != b.level) {
      warn(Kind::door_levels, i,
           name(door) + " joins levels " + std::to_string(a.level) + " and " + std::to_string(b.level) +
               "; correct the rooms' levels, or write 'stairs' or 'elevator'");
      return;
    }
    const auto in_a = find_opening(a, door.at_a, door.width);
    const auto in_b = find_opening(b, door.at_b, door.width);
    if (!in_a || !in_b) return;
    const Vec2 along_a = level_direction(a, a.walls[in_a->wall]);
    const Vec2 along_b = level_direction(b, b.walls[in_b->wall]);
    if (std::abs(cross(along_a, along_b)) > kParallel) {
      warn(Kind::door_position, i,
           name(door) + " stands in walls that are not parallel on the level; correct a 'frame' line or its place");
    }
  }

  static Vec2 level_direction(const Room& room, const Segment& wall) {
    const Vec2 d = room.frame.transform(wall.b) - room.frame.transform(wall.a);
    return (1.0 / norm(d)) * d;
  }

  /// Two doors cannot stand in the same place of one room.
  void lint_neighbours() {
    for (const std::vector<DoorOpening>& openings : find_openings(building_)) {
      for (std::size_t i = 0; i < openings.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
          if (openings[i].wall != openings[k].wall) continue;
          const Vec2 middle_i = 0.5 * (openings[i].span.a + openings[i].span.b);
          const Vec2 middle_k = 0.5 * (openings[k].span.a + openings[k].span.b);
          if (distance(middle_i, middle_k) > kSameDoor) continue;
          warn(Kind::repeated, openings[i].door,
               "the door stands where the one on line " + std::to_string(assembly_.door_lines[openings[k].door].line) +
                   " stands; correct or remove one of them");
        }
      }
    }
  }

  const Assembly& assembly_;
  const Building& building_;
  Phrases phrases_;
  Findings& findings_;
};

}  // namespace

void lint_doors(const Assembly& assembly, Findings& findings) { DoorLint(assembly, findings).run(); }

}  // namespace echoway
