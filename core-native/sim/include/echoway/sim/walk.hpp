#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "echoway/belt/belt.hpp"
#include "echoway/geometry/pose2.hpp"
#include "echoway/sim/world.hpp"

namespace echoway::sim {

/// A place in a room's own frame; the room by its id.
struct Place {
  std::string room;
  Vec2 at{};
};

// What the wearer does.

/// Walks to a place, through doors, stairs and elevators and round corners where need be.
struct GoTo {
  Place to;
};
struct Pause {
  double seconds = 0.0;
};
/// Turns on the spot by an angle, counter-clockwise, radians.
struct TurnBy {
  double angle = 0.0;
};
/// Turns on the spot, the short way, to a heading in the current room's frame, radians.
struct Face {
  double heading = 0.0;
};
/// Is carried to another place, blindfold and in no time.
struct Teleport {
  Place to;
  double heading = 0.0;  ///< In that room's frame, radians.
};
struct SetSpeed {
  double mps = 0.5;
};

// What happens to the wearer.

/// Sensors under a coat or a hand.
struct Cover {
  std::vector<int> sensors;  ///< Empty: all.
  double seconds = 0.0;
};
struct SensorFault {
  enum class Kind : std::uint8_t { dead, stuck, mended } kind = Kind::dead;
  std::vector<int> sensors;  ///< Empty: all.
  double range_m = 1.0;  ///< What a stuck sensor says.
};
/// Shuts or opens the doors between two rooms.
struct SetDoor {
  std::string room_a;
  std::string room_b;
  bool open = false;
};
/// Switches lights with bad ballasts on or off in a room.
struct SetLights {
  std::string room;
  bool on = true;
};

using Action = std::variant<GoTo, Pause, TurnBy, Face, Teleport, SetSpeed, Cover, SensorFault, SetDoor, SetLights>;

/// One line of a walk; takes place when the one before is done.
struct WalkStep {
  Action action;
  int line = 0;  ///< Of the walk file; 0 when made by a program.
};

/// What the wearer does, and in what world. See docs/walk-files.md for the file.
struct Walk {
  std::string file;      ///< Where it was read from; empty when made by a program. For error messages.
  std::string building;  ///< Folder that the walk file names, relative to it; may be empty.
  std::uint64_t seed = 1;
  Place start;
  double start_heading = 0.0;  ///< In the start room's frame, radians.
  int start_line = 0;
  double speed_mps = 0.5;  ///< 1.65 ft/s.
  std::vector<WalkStep> steps;
  World world{};
  BeltConfig belt{};  ///< What the belt is, and what the log says of it.

  void add(Action action, int line = 0);
};

}  // namespace echoway::sim
