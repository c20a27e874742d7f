#include "office_block.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"

namespace echoway {
namespace {

constexpr int kMostPerFloor = 50;

Building draw_office_block(int rooms) {
  const int per_floor = std::min(kMostPerFloor, rooms - 1);
  Building building;
  building.unit = LengthUnit::metres;
  const auto add_room = [&](double width, double depth, int level) {
    Room& room = building.rooms.emplace_back();
    room.id = std::to_string(building.rooms.size());
    room.level = level;
    const Vec2 corners[] = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    for (int i = 0; i < 4; ++i) room.walls.push_back({corners[i], corners[(i + 1) % 4]});
    return static_cast<RoomIndex>(building.rooms.size() - 1);
  };
  for (int level = 0; static_cast<int>(building.rooms.size()) < rooms; ++level) {
    const RoomIndex corridor = add_room(4.0 * ((per_floor + 1) / 2), 2.4, level);
    for (int i = 0; i < per_floor; ++i) {
      const bool below = i % 2 == 0;
      const RoomIndex office = add_room(3.9, 5.0, level);
      const double x = 4.0 * (i / 2) + 1.0;
      building.doors.push_back({corridor, {x, below ? -0.05 : 2.45}, office, {1.0, below ? 5.05 : -0.05}, 0.9});
      building.rooms[static_cast<std::size_t>(office)].frame = {{x - 1.0, below ? -5.1 : 2.5}, 0.0};
    }
    if (level > 0) building.links.push_back({LevelLinkKind::stairs, corridor, {0.5, 1.2}, corridor - per_floor - 1, {0.5, 1.2}});
  }
  return building;
}

}  // namespace

std::filesystem::path write_office_block(int rooms) {
  const auto dir = std::filesystem::temp_directory_path() / ("echoway-bench-" + std::to_string(rooms));
  std::filesystem::remove_all(dir);
  if (!write_building(draw_office_block(rooms), dir).ok()) std::abort();
  return dir;
}

Building office_block(int rooms) {
  const auto dir = write_office_block(rooms);
  auto building = load_building(dir);
  if (!building) std::abort();
  std::filesystem::remove_all(dir);
  return std::move(*building);
}

}  // namespace echoway
