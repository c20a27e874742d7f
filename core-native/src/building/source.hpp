#pragma once

#include <optional>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"

namespace echoway {

// What the files of a building say, line by line, before anything is made of it. Lengths are metres already.

/// Something that stands on a line of a file.
template <class T>
struct Located {
  T what{};
  int line = 0;
};

struct RoomSource {
  std::string id;
  std::string file;
  int counts_line = 0;   ///< Where findings about the whole room are put.
  bool readable = true;  ///< False when some line was malformed: what else there is tells little.
  std::vector<Located<Segment>> walls;
  std::vector<Located<Vec2>> corners;
  std::vector<Located<Vec2>> edges;
  std::vector<Located<Segment>> reflectors;
};

/// One end of a door, of stairs, or any place: a point in a room.
struct PlaceSource {
  std::string room;
  Vec2 at{};
};

struct DoorSource {
  PlaceSource a;
  PlaceSource b;
  std::optional<double> width;
  bool keyword = false;  ///< A `door` line, which says all about a door; the thesis's own lines come one a side.
};

struct LinkSource {
  LevelLinkKind kind = LevelLinkKind::stairs;
  PlaceSource a;
  PlaceSource b;
};

struct RoomNameSource {
  std::string room;
  int level = 0;
  std::string name;
};

struct FrameSource {
  std::string room;
  Pose2 frame{};
};

struct LandmarkSource {
  PlaceSource where;
  std::string name;
};

struct ConfigSource {
  std::string file;
  LengthUnit unit = LengthUnit::feet;
  std::string name;
  std::vector<Located<RoomNameSource>> rooms;
  std::vector<Located<FrameSource>> frames;
  std::vector<Located<DoorSource>> doors;
  std::vector<Located<LinkSource>> links;
  std::vector<Located<LandmarkSource>> exits;
  std::vector<Located<LandmarkSource>> places;
};

struct BuildingSource {
  ConfigSource config;
  std::vector<RoomSource> rooms;  ///< Sorted by id, numbers by value (2 before 10).
};

/// Metres in one of the building's units.
[[nodiscard]] constexpr double metres_per(LengthUnit unit) noexcept {
  return unit == LengthUnit::feet ? kMetresPerFoot : 1.0;
}

}  // namespace echoway
