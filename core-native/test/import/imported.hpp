#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/import/import.hpp"
#include "support/process.hpp"

namespace echoway::import {

/// A plan of test/data/import, imported, written and read back: what a user gets.
struct ImportedPlan {
  Report report;
  Building building;
  std::vector<Finding> findings;

  [[nodiscard]] const Room* room(const std::string& id) const {
    const RoomIndex i = building.find_room(id);
    return i == kNoRoom ? nullptr : &building.room(i);
  }
  [[nodiscard]] std::vector<Door> doors_between(const std::string& a, const std::string& b) const {
    const RoomIndex i = building.find_room(a), j = building.find_room(b);
    std::vector<Door> found;
    for (const Door& door : building.doors) {
      if ((door.room_a == i && door.room_b == j) || (door.room_a == j && door.room_b == i)) found.push_back(door);
    }
    return found;
  }
  [[nodiscard]] bool reports(ReportItem::Kind kind, const std::string& feature, const std::string& words) const {
    return std::any_of(report.items().begin(), report.items().end(), [&](const ReportItem& item) {
      return item.kind == kind && item.source.id == feature && item.message.find(words) != std::string::npos;
    });
  }
  [[nodiscard]] bool repaired(const std::string& feature, const std::string& words) const {
    return reports(ReportItem::Kind::repaired, feature, words);
  }
  [[nodiscard]] bool unresolved(const std::string& feature, const std::string& words) const {
    return reports(ReportItem::Kind::unresolved, feature, words);
  }
  [[nodiscard]] std::vector<std::string> room_ids() const {
    std::vector<std::string> ids;
    for (const Room& r : building.rooms) ids.push_back(r.id);
    return ids;
  }
  [[nodiscard]] std::vector<std::string> place_names() const { return names(building.places); }
  [[nodiscard]] std::vector<std::string> exit_names() const { return names(building.exits); }

 private:
  static std::vector<std::string> names(const std::vector<Landmark>& marks) {
    std::vector<std::string> out;
    for (const Landmark& mark : marks) out.push_back(mark.name);
    return out;
  }
};

inline std::filesystem::path test_plan(const std::string& name) {
  return std::filesystem::path(ECHOWAY_TEST_DATA_DIR) / "import" / name;
}

/// Fails the test when the building cannot be written or loaded.
inline ImportedPlan written_and_read(const ImportedBuilding& imported) {
  ImportedPlan plan;
  const test::TemporaryFolder folder;
  const std::filesystem::path out = folder.path() / "building";
  const Status written = write_imported(imported.building, out, plan.findings);
  EXPECT_TRUE(written) << (written ? "" : written.error().to_string());
  Result<Building> loaded = load_building(out);
  if (loaded) {
    plan.building = std::move(loaded).value();
  } else {
    ADD_FAILURE() << loaded.error().to_string();
  }
  return plan;
}

/// Fails the test when the plan cannot be imported or its building cannot be loaded.
inline ImportedPlan import_plan(SourceFormat format, const std::filesystem::path& source) {
  Report report;
  const auto imported = import_building(format, source, report);
  if (!imported) {
    ADD_FAILURE() << imported.error().to_string();
    return {};
  }
  ImportedPlan plan = written_and_read(*imported);
  plan.report = std::move(report);
  return plan;
}

inline double floor_area(const Room& room) {
  double area = 0.0;
  for (const auto& loop : room.boundary) {
    for (std::size_t i = 0; i < loop.size(); ++i) area += 0.5 * cross(loop[i], loop[(i + 1) % loop.size()]);
  }
  return area;
}

/// Every room closed, every door on a wall of both its rooms and at the same place of the level seen from either.
inline void expect_sound(const Building& building) {
  for (const Room& room : building.rooms) EXPECT_GT(floor_area(room), 0.5) << room.id;
  for (const Door& door : building.doors) {
    const Room& a = building.room(door.room_a);
    const Room& b = building.room(door.room_b);
    const auto off_wall = [](const Room& room, Vec2 at) {
      double nearest = 1e9;
      for (const Segment& wall : room.walls) nearest = std::min(nearest, distance(wall, at));
      return nearest;
    };
    EXPECT_LT(off_wall(a, door.at_a), 0.03) << a.id << " to " << b.id;
    EXPECT_LT(off_wall(b, door.at_b), 0.03) << b.id << " to " << a.id;
    EXPECT_LT(distance(a.frame.transform(door.at_a), b.frame.transform(door.at_b)), 1e-3) << a.id << " to " << b.id;
    EXPECT_GT(door.width, 0.4);
  }
}

}  // namespace echoway::import
