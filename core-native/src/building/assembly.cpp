#include "building/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "building/config_file.hpp"
#include "building/features.hpp"
#include "building/folder.hpp"
#include "building/frames.hpp"
#include "building/phrases.hpp"
#include "building/room_file.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// Elements that all rooms together may have; with kMaxElements it bounds what a hostile building can allocate.
constexpr std::size_t kMaxBuildingElements = 300'000;

class Assembler {
 public:
  Assembler(Assembly& out, Findings& findings) : out_(out), findings_(findings), phrases_(LengthUnit::feet) {}

  void run(const std::filesystem::path& dir) {
    const std::vector<std::string> ids = list_rooms(dir, findings_);
    if (ids.empty()) return;
    ConfigSource& config = out_.source.config;
    config = read_config_file(dir / kConfigName, findings_);
    out_.building.name = config.name;
    out_.building.unit = config.unit;
    phrases_ = Phrases(config.unit);
    if (!read_rooms(dir, ids)) return;
    for (const RoomSource& source : out_.source.rooms) add_room(source);
    name_rooms();
    out_.door_lines = assemble_doors(config, rooms_by_id_, out_.building, findings_);
    if (findings_.any_unusable()) return;
    add_door_jambs(out_.building);
    add_links();
    add_landmarks(config.exits, out_.building.exits, "an exit");
    add_landmarks(config.places, out_.building.places, "a place");
    frame_rooms();
  }

 private:
  bool read_rooms(const std::filesystem::path& dir, const std::vector<std::string>& ids) {
    std::size_t elements = 0;
    for (const std::string& id : ids) {
      RoomSource& room = out_.source.rooms.emplace_back(
          read_room_file(dir / room_file_name(id), id, out_.source.config.unit, findings_));
      elements += room.walls.size() + room.corners.size() + room.edges.size() + room.reflectors.size();
      if (elements > kMaxBuildingElements) {
        findings_.unusable(
            Kind::too_large, room.file, 0,
            "the building has more than " + std::to_string(kMaxBuildingElements) + " elements; split it");
        return false;
      }
    }
    return true;
  }

  void add_room(const RoomSource& source) {
    Building& building = out_.building;
    rooms_by_id_.emplace(source.id, static_cast<RoomIndex>(building.rooms.size()));
    Room& room = building.rooms.emplace_back();
    room.id = source.id;
    std::vector<int>& lines = out_.wall_lines.emplace_back();
    take_walls(source, room, lines);
    take_reflectors(source, room);
    const FloorTrace& floor = out_.floors.emplace_back(trace_floor(room.walls));
    room.boundary = floor.boundary;
    if (floor.closed) {
      derive_features(source, floor, room);
    } else if (source.readable) {
      report_open(source, room, floor, lines);
    }
  }

  void take_walls(const RoomSource& source, Room& room, std::vector<int>& lines) {
    using Ends = std::tuple<double, double, double, double>;
    std::map<Ends, int> seen;
    for (const Located<Segment>& wall : source.walls) {
      const Segment& s = wall.what;
      if (s.length() <= kSamePoint) {
        findings_.warn(
            Kind::no_length, source.file, wall.line,
            "a wall without length at " + phrases_.point(s.a) + " is left out; remove the line or give its other end");
        continue;
      }
      const auto [low, high] = std::minmax({std::pair{s.a.x, s.a.y}, std::pair{s.b.x, s.b.y}});
      const auto [first, is_new] = seen.try_emplace(Ends{low.first, low.second, high.first, high.second}, wall.line);
      if (!is_new) {
        findings_.warn(Kind::repeated, source.file, wall.line,
                       "the wall is the same as on line " + std::to_string(first->second) +
                           " and is left out; remove one of them");
        continue;
      }
      room.walls.push_back(s);
      lines.push_back(wall.line);
    }
  }

  void take_reflectors(const RoomSource& source, Room& room) {
    for (const Located<Segment>& reflector : source.reflectors) {
      if (reflector.what.length() > kSamePoint) {
        room.reflectors.push_back(reflector.what);
      } else {
        findings_.warn(Kind::no_length, source.file, reflector.line,
                       "a reflector without length is left out; give its other end");
      }
    }
  }

  void report_open(const RoomSource& source, const Room& room, const FloorTrace& floor, const std::vector<int>& lines) {
    if (source.walls.empty() || lines.empty()) {
      findings_.unusable(Kind::open_walls, source.file, 0, "has no walls; a room needs walls that enclose its floor");
      return;
    }
    if (floor.free_ends.empty()) {
      findings_.unusable(Kind::open_walls, source.file, 0,
                         "the walls do not close: they enclose no floor; draw the room's outline");
      return;
    }
    const FreeEnd& end = floor.free_ends.front();
    std::string message = "the walls do not close: this wall ends at " + phrases_.point(end.at) + " and meets no other";
    const double gap = gap_at(room.walls, end);
    if (std::isfinite(gap)) message += " (the nearest is " + phrases_.length(gap) + " away)";
    findings_.unusable(Kind::open_walls, source.file, lines[end.wall],
                       message + "; move the end or add the missing wall, across door openings too");
  }

  template <class T>
  Room* room_of(const std::string& id, const Located<T>& line, std::string_view what) {
    const auto found = rooms_by_id_.find(id);
    if (found != rooms_by_id_.end()) return &out_.building.rooms[static_cast<std::size_t>(found->second)];
    findings_.warn(Kind::unknown_room, out_.source.config.file, line.line,
                   std::string(what) + " in room '" + id + "' is left out, since there is no file " +
                       room_file_name(id) + "; correct the id or add the file");
    return nullptr;
  }

  template <class T>
  RoomIndex index_of(const std::string& id, const Located<T>& line, std::string_view what) {
    const Room* room = room_of(id, line, what);
    return room == nullptr ? kNoRoom : static_cast<RoomIndex>(room - out_.building.rooms.data());
  }

  void name_rooms() {
    for (const Located<RoomNameSource>& line : out_.source.config.rooms) {
      if (Room* room = room_of(line.what.room, line, "a name and level")) {
        room->level = line.what.level;
        room->name = line.what.name;
      }
    }
  }

  void add_links() {
    for (const Located<LinkSource>& line : out_.source.config.links) {
      const std::string_view what = line.what.kind == LevelLinkKind::stairs ? "stairs" : "an elevator";
      const RoomIndex a = index_of(line.what.a.room, line, what);
      const RoomIndex b = index_of(line.what.b.room, line, what);
      if (a == kNoRoom || b == kNoRoom) continue;
      out_.building.links.push_back({line.what.kind, a, line.what.a.at, b, line.what.b.at});
    }
  }

  void add_landmarks(const std::vector<Located<LandmarkSource>>& lines, std::vector<Landmark>& list,
                     std::string_view what) {
    for (const Located<LandmarkSource>& line : lines) {
      const RoomIndex room = index_of(line.what.where.room, line, what);
      if (room != kNoRoom) list.push_back({room, line.what.where.at, line.what.name});
    }
  }

  void frame_rooms() {
    std::vector<bool> has_frame(out_.building.rooms.size(), false);
    for (const Located<FrameSource>& line : out_.source.config.frames) {
      const RoomIndex room = index_of(line.what.room, line, "a frame");
      if (room == kNoRoom) continue;
      out_.building.rooms[static_cast<std::size_t>(room)].frame = line.what.frame;
      has_frame[static_cast<std::size_t>(room)] = true;
    }
    out_.pieces = place_rooms(out_.building, has_frame);
  }

  Assembly& out_;
  Findings& findings_;
  Phrases phrases_;
  RoomsById rooms_by_id_;
};

}  // namespace

Assembly assemble_building(const std::filesystem::path& dir, Findings& findings) {
  Assembly out;
  Assembler(out, findings).run(dir);
  return out;
}

}  // namespace echoway
