// Loading and checking a building of many rooms.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/building/writer.hpp"

namespace echoway {
namespace {

/// Offices on both sides of a corridor, floor above floor, 50 rooms and a corridor each.
Building office_block(int rooms) {
  constexpr int kPerFloor = 50;
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
    const RoomIndex corridor = add_room(4.0 * kPerFloor / 2, 2.4, level);
    for (int i = 0; i < kPerFloor; ++i) {
      const bool below = i % 2 == 0;
      const RoomIndex office = add_room(3.9, 5.0, level);
      const double x = 4.0 * (i / 2) + 1.0;
      building.doors.push_back({corridor, {x, below ? -0.05 : 2.45}, office, {1.0, below ? 5.05 : -0.05}, 0.9});
      building.rooms[static_cast<std::size_t>(office)].frame = {{x - 1.0, below ? -5.1 : 2.5}, 0.0};
    }
    if (level > 0) building.links.push_back({LevelLinkKind::stairs, corridor, {0.5, 1.2}, corridor - 51, {0.5, 1.2}});
  }
  return building;
}

std::filesystem::path write_office_block(int rooms) {
  const auto dir = std::filesystem::temp_directory_path() / ("echoway-bench-" + std::to_string(rooms));
  std::filesystem::remove_all(dir);
  if (!write_building(office_block(rooms), dir).ok()) std::abort();
  return dir;
}

void load(benchmark::State& state) {
  const auto dir = write_office_block(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(load_building(dir).ok());
  std::filesystem::remove_all(dir);
}
BENCHMARK(load)->Name("load_building/rooms")->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

void check(benchmark::State& state) {
  const auto dir = write_office_block(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(check_building(dir).size());
  std::filesystem::remove_all(dir);
}
BENCHMARK(check)->Name("check_building/rooms")->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace echoway
