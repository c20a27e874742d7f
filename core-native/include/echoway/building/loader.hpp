#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "echoway/building/building.hpp"
#include "echoway/result.hpp"

namespace echoway {

/// Something to mend in a building folder, found while loading or checking it.
struct Finding {
  enum class Severity { warning, unusable } severity = Severity::warning;
  /// What sort of thing is wrong, for whoever words it in another language than `message`.
  enum class Kind {
    unreadable,      ///< The file cannot be read.
    bad_line,        ///< A line that does not have one of the format's forms.
    wrong_count,     ///< The first line of a room file does not say what follows.
    too_large,       ///< More lines, elements or rooms than a building may have.
    no_rooms,        ///< No room file.
    no_config,       ///< No building.cfg.
    open_walls,      ///< The walls of a room enclose no floor.
    unknown_room,    ///< A line names a room that has no file.
    room_id,         ///< A room's id cannot be written in building.cfg.
    name,            ///< A name is empty, given twice or not UTF-8.
    repeated,        ///< The same thing stands there twice.
    no_length,       ///< A wall or reflector whose ends coincide.
    off_floor,       ///< A thing lies outside its room's floor.
    wall_end,        ///< A wall that ends just short of another.
    cut_off,         ///< Walls cut a room's floor in two.
    corner_or_edge,  ///< A corner or edge that the walls do not have, or one that is missing.
    size,            ///< A room so small or large that the unit must be wrong.
    far_origin,      ///< A room lies far from the origin of its frame.
    door_position,   ///< A door stands in no wall, or its two walls do not fit together.
    door_lines,      ///< The lines about a door disagree, or one is missing.
    door_width,      ///< A door's width is impossible.
    door_levels,     ///< A door joins two levels.
    link_levels,     ///< Stairs or an elevator within one level.
    door_loop,       ///< The way round through other rooms does not meet itself at a door.
    unreachable,     ///< Nothing leads to a room.
    no_place,        ///< A room's place on its level is not known.
    overlap,         ///< Two rooms share floor.
    more,            ///< More findings of this file are left out.
  } kind = Kind::bad_line;
  std::string file;     ///< Path of the file it stands in.
  int line = 0;         ///< 1-based; 0 when it concerns the whole file.
  std::string message;  ///< What is wrong and what to do.

  /// `file:line: message`
  [[nodiscard]] std::string to_string() const { return Error{message, file, line}.to_string(); }
};

/// Reads `building.cfg` and every `room-R.room` in `dir`, derives corners and edges that a file leaves out, chains
/// rooms door to door into their level's frame and fills boundaries. Fails with the first finding that makes the
/// building unusable (docs/formats.md lists them).
Result<Building> load_building(const std::filesystem::path& dir);

/// All findings of a building folder, the unusable ones first, else in order of file and line.
[[nodiscard]] std::vector<Finding> check_building(const std::filesystem::path& dir);

}  // namespace echoway
