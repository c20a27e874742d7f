#include <algorithm>
#include <cmath>
#include <string_view>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "plans/scratch_folder.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

using plans::ScratchFolder;

/// The input is a folder in one piece: a line `=== NAME` starts a file, the lines below it are its contents.
void unpack(std::string_view text, const ScratchFolder& folder) {
  constexpr std::string_view kMark = "=== ";
  std::string name;
  std::string contents;
  const auto finish = [&] {
    // Room names with a folder in them would leave the scratch folder.
    const bool usable = !name.empty() && name.size() < 64 && name.find('/') == std::string::npos &&
                        name.find('\0') == std::string::npos && name != "." && name != "..";
    if (usable) folder.write(name, contents);
    contents.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    const std::string_view line = text.substr(0, end + 1);
    text.remove_prefix(end + 1);
    if (line.starts_with(kMark)) {
      finish();
      name = std::string(line.substr(kMark.size(), line.find_last_not_of("\r\n") + 1 - kMark.size()));
    } else {
      contents += line;
    }
  }
  finish();
}

bool finite(const std::vector<Segment>& segments) {
  return std::all_of(segments.begin(), segments.end(),
                     [](const Segment& s) { return is_finite(s.a) && is_finite(s.b); });
}
bool finite(const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec2 p) { return is_finite(p); });
}

std::string check_room(const Room& room) {
  const bool all_finite =
      finite(room.walls) && finite(room.reflectors) && finite(room.corners) && finite(room.edges) &&
      is_finite(room.frame) &&
      std::all_of(room.boundary.begin(), room.boundary.end(), [](const auto& l) { return finite(l); });
  if (!all_finite) return "a room has something that is not finite";
  if (room.boundary.empty()) return "a room without a floor";
  for (std::size_t i = 0; i < room.boundary.size(); ++i) {
    if (room.boundary[i].size() < 3) return "a loop of fewer than three points";
    const double area = signed_area(room.boundary[i]);
    if (i == 0 ? !(area > 0.0) : !(area < 0.0)) return "a loop that runs the wrong way round";
  }
  return "";
}

std::string check(const Building& building) {
  if (building.rooms.empty()) return "a building without a room";
  for (const Room& room : building.rooms) {
    if (std::string broken = check_room(room); !broken.empty()) return broken;
  }
  for (const Door& door : building.doors) {
    if (!building.has_room(door.room_a) || !building.has_room(door.room_b)) return "a door to no room";
    if (!is_finite(door.at_a) || !is_finite(door.at_b) || !(door.width > 0.0) || !std::isfinite(door.width)) {
      return "a door that is not finite";
    }
  }
  for (const LevelLink& link : building.links) {
    if (!building.has_room(link.room_a) || !building.has_room(link.room_b)) return "stairs to no room";
  }
  for (const auto* landmarks : {&building.exits, &building.places}) {
    for (const Landmark& landmark : *landmarks) {
      if (!building.has_room(landmark.room) || !is_finite(landmark.at)) return "a place that is nowhere";
    }
  }
  for (const LoopClosure& closure : building.loop_closures) {
    if (closure.door >= building.doors.size() || !std::isfinite(closure.error)) return "a loop that is not finite";
  }
  return "";
}

std::string check_round_trip(const Building& building) {
  const ScratchFolder folder("fuzz-building-out");
  if (!write_building(building, folder.path())) return "";
  const Result<Building> again = load_building(folder.path());
  if (!again) return "what was written cannot be read: " + again.error().to_string();
  const bool same = again->rooms.size() == building.rooms.size() && again->doors.size() == building.doors.size() &&
                    again->exits.size() == building.exits.size() && again->places.size() == building.places.size();
  return same ? "" : "what was written reads back as something else";
}

}  // namespace

std::string building(Bytes data) {
  const ScratchFolder folder("fuzz-building");
  unpack({reinterpret_cast<const char*>(data.data()), data.size()}, folder);
  const Result<Building> loaded = load_building(folder.path());
  const std::vector<Finding> findings = check_building(folder.path());
  const bool unusable = std::any_of(findings.begin(), findings.end(), [](const Finding& f) {
    return f.severity == Finding::Severity::unusable;
  });
  if (loaded.ok() == unusable) return "loading and checking disagree";
  if (!loaded) return loaded.error().message.empty() ? "an error without words" : "";
  if (std::string broken = check(*loaded); !broken.empty()) return broken;
  return check_round_trip(*loaded);
}

}  // namespace echoway::fuzz
