#pragma once

#include <filesystem>

#include "echoway/building/building.hpp"

namespace echoway {

/// Offices on both sides of a corridor, floor above floor: 50 offices and a corridor each, fewer when `rooms` is less. All
/// offices are alike. A larger block begins with the rooms of a smaller one.
[[nodiscard]] Building office_block(int rooms);
/// The same as a folder in the system's temporary one, for the caller to remove.
[[nodiscard]] std::filesystem::path write_office_block(int rooms);

}  // namespace echoway
