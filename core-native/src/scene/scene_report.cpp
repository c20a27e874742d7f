#include "echoway/scene/scene_report.hpp"

#include <algorithm>
#include <cstdio>

#include "scene/scene.hpp"
#include "tracker/echo_model.hpp"

namespace echoway {
namespace {

using scene::Cell;
using scene::ReflectorKind;

RoomSavings count_room(scene::Scene& compiled, RoomIndex index, const scene::RoomScene& whole) {
  const scene::RoomScene& room = compiled.room(index);
  RoomSavings out;
  out.room = index;
  out.reflectors = whole.reflectors.size();
  out.occluders = whole.occluders.size();
  double cells = 0.0;
  for (int row = 0; row < room.rows; ++row) {
    for (int column = 0; column < room.columns; ++column) {
      const Vec2 centre = room.grid_origin + room.cell_size * Vec2{column + 0.5, row + 0.5};
      if (!room.floor.contains(centre)) continue;
      const Cell& cell = compiled.cell_at(index, centre);
      cells += 1.0;
      out.plain_floor += cell.plain_floor;
      for (std::size_t s = 0; s < Cell::kSectors; ++s) {
        for (unsigned i = cell.sector_begin[s]; i < cell.sector_begin[s + 1]; ++i) {
          if ((cell.items[i] & Cell::kCoarseOnly) != 0) continue;
          const Cell::Entry& entry = cell.entries[cell.items[i]];
          const ReflectorKind kind = room.reflectors[entry.reflector].kind;
          out.considered += 1.0 / Cell::kSectors;
          out.hidden_tests += static_cast<double>(entry.occluder_count) / Cell::kSectors;
          out.edges |= kind == ReflectorKind::edge;
          out.all_reflective |= kind == ReflectorKind::all_reflective;
        }
      }
    }
  }
  if (cells > 0.0) {
    out.considered /= cells;
    out.hidden_tests /= cells;
    out.plain_floor /= cells;
  }
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
    report.rooms.push_back(count_room(compiled, room, compiler.compile(room)));
    report.levels |= building.rooms[i].level != building.rooms[0].level;
  }
  report.bytes = compiled.memory();
  return report;
}

std::string to_string(const SceneReport& report, const Building& building) {
  std::string out = "room            reflectors  looked at  sight tests (of)       edges  all-reflective  no room logic\n";
  char line[200];
  for (const RoomSavings& r : report.rooms) {
    std::snprintf(line, sizeof line, "%-15s %10zu %10.2f %10.2f (%.0f) %12s %15s %13.0f%%\n", building.room(r.room).id.c_str(),
                  r.reflectors, r.considered, r.hidden_tests, r.considered * static_cast<double>(r.occluders),
                  r.edges ? "yes" : "left out", r.all_reflective ? "yes" : "left out", 100.0 * r.plain_floor);
    out += line;
  }
  std::snprintf(line, sizeof line, "levels: %s; %.2f MB\n", report.levels ? "yes" : "left out", static_cast<double>(report.bytes) / 1e6);
  return out + line;
}

}  // namespace echoway
