#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "building/findings.hpp"

namespace echoway {

inline constexpr std::string_view kConfigName = "building.cfg";

/// Rooms that one building may have.
inline constexpr std::size_t kMaxRooms = 20'000;

/// `room-<id>.room`
[[nodiscard]] std::string room_file_name(std::string_view id);

/// Whether a room can be called so: a word that neither building.cfg nor a log would break at, in UTF-8.
[[nodiscard]] bool is_room_id(std::string_view id) noexcept;

/// Ids of the rooms in `dir`, digits compared by value (2 before 10). Reports a folder that cannot be read or has none.
[[nodiscard]] std::vector<std::string> list_rooms(const std::filesystem::path& dir, Findings& findings);

}  // namespace echoway
