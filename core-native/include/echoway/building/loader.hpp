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
  std::string file;     ///< Path of the file it stands in.
  int line = 0;         ///< 1-based; 0 when it concerns the whole file.
  std::string message;  ///< What is wrong and what to do.

  /// `file:line: message`
  [[nodiscard]] std::string to_string() const { return Error{message, file, line}.to_string(); }
};

/// Reads `building.cfg` and every `room-R.room` in `dir`, derives corners and edges that a file leaves out, chains rooms
/// door to door into their level's frame and fills boundaries. Fails with the first finding that makes the building
/// unusable (docs/formats.md lists them).
Result<Building> load_building(const std::filesystem::path& dir);

/// All findings of a building folder, the unusable ones first, else in order of file and line.
[[nodiscard]] std::vector<Finding> check_building(const std::filesystem::path& dir);

}  // namespace echoway
