#include "office_block.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "../test/support/plans.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"

namespace echoway {

Building draw_office_block(int rooms) {
  const int per_side = std::clamp((rooms - 1) / 2, 1, 25);
  const double end = 4.0 * per_side - 0.5;
  Building block;
  block.unit = LengthUnit::metres;
  for (int level = 0; static_cast<int>(block.rooms.size()) < rooms; ++level) {
    const auto base = static_cast<RoomIndex>(block.rooms.size());
    Building floor = test::make_office_floor(per_side);
    const auto below = base - static_cast<RoomIndex>(floor.rooms.size());
    for (Room& room : floor.rooms) {
      room.id.append("-").append(std::to_string(level));
      room.level = level;
      block.rooms.push_back(std::move(room));
    }
    for (Door door : floor.doors) {
      door.room_a += base;
      door.room_b += base;
      block.doors.push_back(door);
    }
    if (level == 0) continue;
    block.links.push_back({LevelLinkKind::stairs, below, {0.5, 1.2}, base, {0.5, 1.2}});
    block.links.push_back({LevelLinkKind::elevator, below, {end, 1.2}, base, {end, 1.2}});
  }
  return block;
}

std::filesystem::path write_office_block(int rooms) {
  const auto dir = std::filesystem::temp_directory_path() / ("echoway-bench-" + std::to_string(rooms));
  std::filesystem::remove_all(dir);
  if (!write_building(draw_office_block(rooms), dir).ok()) std::abort();
  return dir;
}

Building load_office_block(int rooms) {
  const auto dir = write_office_block(rooms);
  auto building = load_building(dir);
  if (!building) std::abort();
  std::filesystem::remove_all(dir);
  return std::move(*building);
}

}  // namespace echoway
