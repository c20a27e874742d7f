#pragma once

#include <string>

#include "echoway/building/building.hpp"

namespace echoway {

/// What a room is called aloud, whatever the language: "Room `number`, `name`".
struct RoomName {
  std::string number;  ///< What is said after "Room"; empty for a room that is called by its name alone.
  std::string name;    ///< What is said besides, or instead; empty when the number says all.
};

/// By what stands on the room's door, where the files say it. An id that was made of the name ("2-main-corridor") is
/// for files, not for ears, and so is the level in the id of a room without a name ("2-room-7"), for the level is told
/// where it changes. A name that is a number ("2.07", "B 12") is said as one.
[[nodiscard]] RoomName room_name(const Room& room);

}  // namespace echoway
