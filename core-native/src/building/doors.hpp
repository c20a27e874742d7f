#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "building/findings.hpp"
#include "building/source.hpp"

namespace echoway {

using RoomsById = std::unordered_map<std::string_view, RoomIndex>;

/// Two lines about the same two rooms whose doors are this near, in both rooms, mean the same door.
inline constexpr double kSameDoor = feet(1.5);

inline constexpr double kDefaultDoorWidth = feet(3.0);

/// Jambs farther apart are not the two sides of one door.
inline constexpr double kWidestDoor = feet(12.0);

/// Which lines of building.cfg made a door, for messages about it. Index as in Building::doors.
struct DoorLines {
  int line = 0;         ///< The first of them.
  bool from_a = false;  ///< A thesis line that starts with room_a.
  bool from_b = false;
  bool keyword = false;  ///< A `door` line.
  bool width_given = false;
  double disagreement = 0.0;  ///< Between the lines about where it is, metres.
};

/// Fills Building::doors from the lines of building.cfg, which may say the same door once or once a side. REQUIRES:
/// rooms with walls and features.
[[nodiscard]] std::vector<DoorLines> assemble_doors(const ConfigSource& config, const RoomsById& rooms,
                                                    Building& building, Findings& findings);

/// Door frames diffract (thesis section 5.1): adds an edge at both ends of every opening where the room has none.
void add_door_jambs(Building& building);

}  // namespace echoway
