#include <array>
#include <limits>
#include <map>
#include <set>

#include "building/lint.hpp"
#include "building/phrases.hpp"
#include "echoway/building/opening.hpp"
#include "echoway/geometry/inclusion.hpp"

namespace echoway {
namespace {

using Kind = Finding::Kind;

/// An exit or stairs may stand in their wall, or a little behind it.
constexpr double kInDoorway = feet(1.0);

constexpr std::array<std::string_view, 9> kKeywords{"units", "name",   "room",     "frame", "door",
                                                    "exit",  "stairs", "elevator", "place"};

class LandmarkLint {
 public:
  LandmarkLint(const Assembly& assembly, Findings& findings)
      : assembly_(assembly),
        config_(assembly.source.config),
        building_(assembly.building),
        phrases_(assembly.building.unit),
        findings_(findings) {
    for (std::size_t i = 0; i < building_.rooms.size(); ++i) rooms_.emplace(building_.rooms[i].id, i);
  }

  void run() {
    lint_ids();
    lint_repeated(config_.rooms, "a 'room' line");
    lint_repeated(config_.frames, "a 'frame' line");
    for (const auto& link : config_.links) {
      lint_place(link.what.a, link.line, "the way up or down");
      lint_place(link.what.b, link.line, "the way up or down");
      lint_levels_joined(link);
    }
    for (const auto& exit : config_.exits) lint_place(exit.what.where, exit.line, "the exit");
    std::set<std::string> names;
    for (const auto& place : config_.places) {
      lint_place(place.what.where, place.line, "the place");
      if (place.what.name.empty()) {
        warn(Kind::name, place.line, "the place has an empty name and nobody can ask for it; name it");
      } else if (!names.insert(place.what.name).second) {
        warn(Kind::name, place.line, "another place is called \"" + place.what.name + "\" too; give each its own name");
      }
    }
  }

 private:
  void warn(Kind kind, int line, std::string message) { findings_.warn(kind, config_.file, line, std::move(message)); }

  void lint_ids() {
    for (std::size_t i = 0; i < building_.rooms.size(); ++i) {
      for (const std::string_view keyword : kKeywords) {
        if (building_.rooms[i].id != keyword) continue;
        findings_.warn(
            Kind::room_id, assembly_.source.rooms[i].file, 0,
            "the room's id is a keyword of building.cfg, where no door line can start with it; rename the room");
      }
    }
  }

  template <class T>
  void lint_repeated(const std::vector<Located<T>>& lines, const std::string& what) {
    std::map<std::string, int> first;
    for (const Located<T>& line : lines) {
      const auto [known, is_new] = first.try_emplace(line.what.room, line.line);
      if (is_new) continue;
      warn(Kind::repeated, line.line,
           "room '" + line.what.room + "' has " + what + " already, on line " + std::to_string(known->second) +
               "; the last one counts, remove the others");
    }
  }

  void lint_place(const PlaceSource& place, int line, const std::string& what) {
    const auto found = rooms_.find(place.room);
    if (found == rooms_.end()) return;
    const Room& room = building_.rooms[found->second];
    if (contains(room.boundary, place.at)) return;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& wall : room.walls) nearest = std::min(nearest, distance(wall, place.at));
    if (nearest <= kInDoorway) return;
    warn(Kind::off_floor, line,
         what + " at " + phrases_.point(place.at) + " lies outside the floor of room '" + place.room + "', " +
             phrases_.length(nearest) + " from its walls; correct its position");
  }

  void lint_levels_joined(const Located<LinkSource>& link) {
    const auto a = rooms_.find(link.what.a.room);
    const auto b = rooms_.find(link.what.b.room);
    if (a == rooms_.end() || b == rooms_.end()) return;
    const int level = building_.rooms[a->second].level;
    if (building_.rooms[b->second].level != level) return;
    const bool stairs = link.what.kind == LevelLinkKind::stairs;
    warn(Kind::link_levels, link.line,
         (stairs ? "the stairs join" : "the elevator joins") + (" rooms '" + link.what.a.room) + "' and '" +
             link.what.b.room + "', both on level " + std::to_string(level) +
             "; correct the rooms' levels, or write a door");
  }

  const Assembly& assembly_;
  const ConfigSource& config_;
  const Building& building_;
  Phrases phrases_;
  Findings& findings_;
  std::map<std::string_view, std::size_t> rooms_;
};

}  // namespace

void lint_landmarks(const Assembly& assembly, Findings& findings) { LandmarkLint(assembly, findings).run(); }

}  // namespace echoway
