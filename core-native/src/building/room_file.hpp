#pragma once

#include <filesystem>

#include "building/findings.hpp"
#include "building/source.hpp"

namespace echoway {

/// Elements that one room may have; more is no room but an accident or an attack.
inline constexpr std::size_t kMaxElements = 5000;

/// Reads a room file (thesis section 5.1, table 5.2; docs/formats.md). What is wrong with it goes to `findings`.
[[nodiscard]] RoomSource read_room_file(const std::filesystem::path& file, std::string id, LengthUnit unit,
                                        Findings& findings);

}  // namespace echoway
