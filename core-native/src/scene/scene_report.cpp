#include "echoway/scene/scene_report.hpp"

#include <algorithm>

#include "scene/scene.hpp"
#include "tracker/echo_model.hpp"

namespace echoway {
namespace {

using scene::Cell;
using scene::Reflector;
using scene::ReflectorKind;
using scene::RoomScene;

void count(ReflectorKind kind, EchoSources& sources) noexcept {
  switch (kind) {
    case ReflectorKind::wall: ++sources.walls; break;
    case ReflectorKind::corner: ++sources.corners; break;
    case ReflectorKind::edge: ++sources.edges; break;
    case ReflectorKind::all_reflective: ++sources.all_reflective; break;
    case ReflectorKind::mirrored_corner: ++sources.mirrored_corners; break;
  }
}

EchoSources count(const std::vector<Reflector>& reflectors) noexcept {
  EchoSources sources;
  for (const Reflector& r : reflectors) count(r.kind, sources);
  return sources;
}

// Adds what one place keeps, and marks in `heard` what can be heard there.
void add_place(const Cell& cell, RoomSavings& sums, std::vector<bool>& heard) {
  sums.plain_floor += cell.plain_floor;
  sums.listed += static_cast<double>(cell.entries.size());
  for (const Cell::Entry& entry : cell.entries) heard[entry.reflector] = true;
  for (const std::uint16_t item : cell.items) {
    if ((item & Cell::kCoarseOnly) != 0) continue;
    sums.looked_at += 1.0 / Cell::kSectors;
    sums.sight_tests += static_cast<double>(cell.entries[item].occluder_count) / Cell::kSectors;
  }
}

// Adds up all places that touch the room's floor; returns how many.
int add_places(scene::Scene& compiled, RoomIndex index, RoomSavings& sums, std::vector<bool>& heard) {
  const RoomScene& room = compiled.room(index);
  const Vec2 size{room.cell_size, room.cell_size};
  int places = 0;
  for (int row = 0; row < room.rows; ++row) {
    for (int column = 0; column < room.columns; ++column) {
      const Vec2 low = room.grid_origin + room.cell_size * Vec2{static_cast<double>(column), static_cast<double>(row)};
      const Vec2 centre = low + 0.5 * size;
      if (!room.floor.contains(centre) && !room.floor.crossed_by_box(low, low + size)) continue;
      add_place(compiled.cell_at(index, centre), sums, heard);
      ++places;
    }
  }
  return places;
}

RoomSavings count_room(scene::Scene& compiled, RoomIndex index, const RoomScene& whole) {
  const std::vector<Reflector>& reflectors = compiled.room(index).reflectors;
  RoomSavings out;
  out.room = index;
  out.within_reach = count(whole.reflectors);
  out.sight_blockers = whole.occluders.size();
  std::vector<bool> heard(reflectors.size());
  const int places = add_places(compiled, index, out, heard);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    if (heard[i]) count(reflectors[i].kind, out.heard);
  }
  if (places == 0) return out;
  for (double* sum : {&out.listed, &out.looked_at, &out.sight_tests, &out.plain_floor}) *sum /= places;
  return out;
}

}  // namespace

SceneReport report_scene(const Building& building, const BeltConfig& belt) {
  const tracker::EchoModel model(belt, {});
  scene::Scene compiled(building, model.sight_limits());
  const scene::RoomCompiler compiler(building, model.sight_limits().max_range, scene::kCellSize);
  SceneReport report;
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    const auto room = static_cast<RoomIndex>(i);
    const RoomScene whole = compiler.compile(room);
    report.sources += static_cast<std::size_t>(
        std::ranges::count_if(whole.reflectors, [](const Reflector& r) { return r.opening < 0; }));
    report.rooms.push_back(count_room(compiled, room, whole));
    report.levels |= building.rooms[i].level != building.rooms[0].level;
  }
  report.bytes = compiled.memory();
  return report;
}

}  // namespace echoway
