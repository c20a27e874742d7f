#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "echoway/geometry/pose2.hpp"
#include "echoway/geometry/segment.hpp"
#include "echoway/units.hpp"

namespace echoway {

/// Index into Building::rooms.
using RoomIndex = std::int32_t;
inline constexpr RoomIndex kNoRoom = -1;

enum class LengthUnit : std::uint8_t { feet, metres };

/// One room of the floor plan (thesis section 5.1, table 5.2). All coordinates are metres in the room's own frame,
/// whatever unit its file uses. Walls run through door openings; the openings are cut where Building::doors says.
struct Room {
  std::string id;                     ///< Token without blanks, as in `room-<id>.room`.
  std::string name;                   ///< What a wearer would call it; empty when the building does not say.
  int level = 0;
  std::vector<Segment> walls;         ///< Plane, specular reflectors (thesis type 1).
  std::vector<Vec2> corners;          ///< Concave right angles: retro-reflectors (type 2).
  std::vector<Vec2> edges;            ///< Convex corners and door jambs: diffract (type 3).
  std::vector<Segment> reflectors;    ///< All-reflective elements: echo at any incidence (type 4, thesis 6.2.1).
  Pose2 frame{};                      ///< Takes the room's frame into its level's frame.

  /// Closed loops that bound the floor, first the outer one (counter-clockwise), then holes (clockwise); filled by the
  /// loader from `walls` with free-standing screens and stubs left out, so that an even-odd test is right everywhere.
  std::vector<std::vector<Vec2>> boundary;
};

/// A door joins two rooms; it is the same place on the plan seen from two frames.
struct Door {
  RoomIndex room_a = kNoRoom;
  Vec2 at_a{};                        ///< Centre of the opening in room_a's frame.
  RoomIndex room_b = kNoRoom;
  Vec2 at_b{};                        ///< Centre of the same opening in room_b's frame.
  double width = feet(3.0);           ///< Clear width of the opening, metres.

  /// The room that it leads to from `here`, one of its two.
  [[nodiscard]] RoomIndex beyond(RoomIndex here) const noexcept { return room_a == here ? room_b : room_a; }
};

enum class LevelLinkKind : std::uint8_t { stairs, elevator };

/// Stairs or an elevator between two levels.
struct LevelLink {
  LevelLinkKind kind = LevelLinkKind::stairs;
  RoomIndex room_a = kNoRoom;
  Vec2 at_a{};
  RoomIndex room_b = kNoRoom;
  Vec2 at_b{};

  /// The room that it leads to from `here`, one of its two.
  [[nodiscard]] RoomIndex beyond(RoomIndex here) const noexcept { return room_a == here ? room_b : room_a; }
};

/// A named point: a destination (`place`) or a way out of the building (`exit`).
struct Landmark {
  RoomIndex room = kNoRoom;
  Vec2 at{};
  std::string name;
};

/// How badly a loop of doors fails to close when rooms are chained into their level's frame (translation mismatch at
/// the door that closes the loop, metres).
struct LoopClosure {
  std::size_t door = 0;               ///< Index into Building::doors.
  double error = 0.0;
};

/// A floor plan: rooms, and what joins them. See docs/formats.md for the files.
struct Building {
  std::string name;
  LengthUnit unit = LengthUnit::feet; ///< Of the files; coordinates here are always metres.
  std::vector<Room> rooms;
  std::vector<Door> doors;
  std::vector<LevelLink> links;
  std::vector<Landmark> exits;
  std::vector<Landmark> places;
  std::vector<LoopClosure> loop_closures;

  /// Whether `i` is one of this building's rooms. False for kNoRoom and for any other number that comes from outside.
  [[nodiscard]] bool has_room(RoomIndex i) const noexcept {
    return i >= 0 && static_cast<std::size_t>(i) < rooms.size();
  }
  [[nodiscard]] RoomIndex find_room(std::string_view id) const noexcept {
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (rooms[i].id == id) return static_cast<RoomIndex>(i);
    }
    return kNoRoom;
  }
  /// REQUIRES: has_room(i).
  [[nodiscard]] const Room& room(RoomIndex i) const { return rooms[static_cast<std::size_t>(i)]; }
};

}  // namespace echoway
