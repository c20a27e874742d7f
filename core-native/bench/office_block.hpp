#pragma once

#include <filesystem>

#include "echoway/building/building.hpp"

namespace echoway {

/// At least `rooms` rooms: a hall with 50 offices, all alike, fewer when `rooms` is less, floor above floor, joined by
/// stairs and an elevator at the hall's ends. A larger block begins with the rooms of a smaller one of whole floors.
[[nodiscard]] Building draw_office_block(int rooms);
/// The same as a folder in the system's temporary one, for the caller to remove,
[[nodiscard]] std::filesystem::path write_office_block(int rooms);
/// and as loaded from there: corners and edges worked out.
[[nodiscard]] Building load_office_block(int rooms);

}  // namespace echoway
