#include "scene/cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/random.hpp"
#include "scene/scene.hpp"
#include "scene/visibility.hpp"
#include "support/looking.hpp"
#include "support/plans.hpp"
#include "support/whole_room.hpp"
#include "tracker/likelihood.hpp"
#include "tracker/elementary.hpp"
#include "tracker/plans.hpp"

namespace echoway {
namespace {

using tracker::ExpectedEchoes;

Building furnished_office() {
  Building b = test::small_office();
  b.rooms[1].reflectors.push_back({{1.0, 3.4}, {2.6, 3.4}});
  b.rooms[0].walls.push_back({{4.0, 0.6}, {4.0, 1.4}});  // A screen in the hall.
  return b;
}

// Compares firings from random places in every `stride`-th cell of the building's rooms with the whole room. Returns
// how many echoes were compared.
int compare_cells(const Building& building, std::size_t stride, int firings_per_cell) {
  const BeltConfig belt;
  const tracker::EchoModel model(belt, {});
  scene::Scene compiled(building, model.sight_limits());
  const scene::RoomCompiler compiler(building, model.sight_limits().max_range, scene::kCellSize);
  Random random(4);
  int compared = 0;
  std::size_t cells = 0;
  for (std::size_t r = 0; r < building.rooms.size(); ++r) {
    const test::WholeRoom whole(compiler.compile(static_cast<RoomIndex>(r)));
    const scene::RoomScene& room = compiled.room(static_cast<RoomIndex>(r));
    for (int c = 0; c < room.columns * room.rows; ++c) {
      if (cells++ % stride != 0) continue;
      const double column = c % room.columns;
      const double row = c / room.columns;
      for (int i = 0; i < firings_per_cell; ++i) {
        const Vec2 within{column + random.uniform(0.0, 1.0), row + random.uniform(0.0, 1.0)};
        const Vec2 place = room.grid_origin + room.cell_size * within;
        const auto p = test::standing(static_cast<RoomIndex>(r), place, random.uniform(-kPi, kPi));
        tracker::Shot shot;
        shot.coarse = i % 3 == 0;
        const ExpectedEchoes some = tracker::expect(p, shot, model, compiled);
        SCOPED_TRACE(::testing::Message()
                     << "room " << building.rooms[r].id << " at " << p.position.x << ", " << p.position.y << " heading "
                     << p.heading << (shot.coarse ? " coarse" : ""));
        test::expect_same(some, whole.expect(p, shot, model));
        if (::testing::Test::HasFatalFailure()) return compared;
        compared += some.count;
      }
    }
  }
  return compared;
}

TEST(Cell, LeavingOutWhatAPlaceCannotHearChangesNoEcho) {
  EXPECT_GT(compare_cells(furnished_office(), 1, 12), 1000);
}

Building map(const char* name) {
  Result<Building> loaded = load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / name);
  EXPECT_TRUE(loaded.ok());
  return std::move(*loaded);
}

TEST(Cell, OfARealFloorGivesTheEchoesOfTheWholeRoom) {
  EXPECT_GT(compare_cells(map("torgersen-lab"), 1, 30), 1000);
  EXPECT_GT(compare_cells(map("similar-rooms"), 1, 30), 1000);
}

TEST(Cell, OfALargeRealBuildingGivesTheEchoesOfTheWholeRoom) {
  EXPECT_GT(compare_cells(map("westport-house"), 37, 12), 1000);
}

void add_ring(Room& room, Vec2 centre, double radius, int screens) {
  for (int i = 0; i < screens; ++i) {
    const Vec2 out = unit_from_angle(kTwoPi * i / screens);
    const Vec2 along = 0.09 * perpendicular(out);
    const Vec2 at = centre + radius * out;
    room.walls.push_back({at - along, at + along});
  }
}

TEST(Cell, OfACrowdedRoomGivesTheEchoesOfTheWholeRoom) {
  Building building;
  building.rooms.push_back(test::make_box("screens", 10.0, 10.0));
  const Vec2 centre{4.95, 4.95};
  add_ring(building.rooms[0], centre, 1.4, 36);
  add_ring(building.rooms[0], centre, 2.4, 24);
  EXPECT_GT(compare_cells(building, 1, 30), 1000);
}

TEST(Cell, OfARoomWithMoreInTheWayThanItCanListGivesTheEchoesOfTheWholeRoom) {
  Building building;
  Room room = test::make_box("mirrors", 10.0, 10.0);
  for (int i = 0; i < 180; ++i) {
    const Vec2 at = Vec2{5.0, 5.0} + (0.6 + 0.02 * i) * unit_from_angle(2.4 * i);
    room.walls.push_back({at, at + 0.3 * unit_from_angle(0.7 * i)});
    if (i % 3 == 0) room.corners.push_back(at);
  }
  building.rooms.push_back(room);
  scene::Scene compiled(building, tracker::EchoModel(BeltConfig{}, {}).sight_limits());
  const scene::Cell& cell = compiled.cell_at(0, {2.0, 2.0});
  const auto tests_all = [&](const scene::Cell::Entry& e) {
    return e.occluder_count == compiled.room(0).occluders.size();
  };
  ASSERT_TRUE(std::ranges::any_of(cell.entries, tests_all)) << cell.entries.size() << " " << cell.occluders.size();
  EXPECT_GT(compare_cells(building, 5, 10), 1000);
}

TEST(Cell, BesideTheEndOfAWallStillHearsIt) {
  Building building;
  building.rooms.push_back(test::make_box("screen", 10.0, 10.0));
  building.rooms[0].walls.push_back({{2.0, 8.0}, {4.69, 8.0}});
  const tracker::EchoModel model(BeltConfig{}, {});
  scene::Scene compiled(building, model.sight_limits());
  tracker::Particle p;
  p.room = 0;
  p.position = {4.72, 4.0};
  p.heading = 0.5 * kPi;
  p.facing = {0.0, 1.0};
  ASSERT_GT(compiled.room(0).grid_origin.x + 10 * compiled.room(0).cell_size, 4.69)
      << "The cell must lie beyond the end.";
  const ExpectedEchoes echoes = tracker::expect(p, {}, model, compiled);
  ASSERT_GT(echoes.count, 0);
  EXPECT_DOUBLE_EQ(echoes.echo[0].range, 4.0);
}

bool hears(const Building& building, const tracker::Particle& p, double range) {
  const tracker::EchoModel model(BeltConfig{}, {});
  scene::Scene compiled(building, model.sight_limits());
  const ExpectedEchoes echoes = tracker::expect(p, {}, model, compiled);
  const auto end = echoes.echo.begin() + echoes.count;
  return std::any_of(echoes.echo.begin(), end,
                     [&](const tracker::ExpectedEcho& e) { return std::abs(e.range - range) < 1e-6; });
}

TEST(Cell, KnowsWhatStandsOnTheWayFromAMirrorEvenBesideWhereAllWaysLead) {
  Building building;
  building.rooms.push_back(test::make_box("mirror", 10.0, 10.0));
  const Vec2 corner{4.2, 1.5};
  const Vec2 image{4.2, -1.5};
  building.rooms[0].corners.push_back(corner);
  tracker::Particle p;
  p.room = 0;
  p.position = {2.2001, 2.7001};   // Where a cell begins: sound meets the wall at y = 0 nowhere farther to the left.
  const Vec2 way = image - p.position;
  p.heading = std::atan2(way.y, way.x);
  p.facing = (1.0 / norm(way)) * way;
  ASSERT_TRUE(hears(building, p, norm(way)));

  // A screen ends between the way from the wall itself and the one from just before it, which is what counts.
  const Vec2 via = p.position + p.position.y / (p.position.y + corner.y) * way;
  const Vec2 on_wall = 0.5 * (via + corner);
  const Vec2 off_wall = 0.5 * (scene::in_front_of(via, p.position, distance(via, p.position)) + corner);
  building.rooms[0].walls.push_back({0.5 * (on_wall + off_wall), on_wall + 8.0 * (off_wall - on_wall)});
  EXPECT_FALSE(hears(building, p, norm(way)));
}

TEST(Scene, LeavesOutBeyondDoorsWhatNobodyInARoomCouldHear) {
  const Building grid = test::make_grid(5, 5);
  const scene::SightLimits limits = tracker::EchoModel(BeltConfig{}, {}).sight_limits();
  const scene::RoomCompiler whole(grid, limits.max_range, scene::kCellSize);
  const scene::Scene compiled(grid, limits);
  for (RoomIndex r = 0; r < 25; ++r) {
    const scene::RoomScene all = whole.compile(r);
    EXPECT_LT(compiled.room(r).reflectors.size(), 0.6 * static_cast<double>(all.reflectors.size()));
    EXPECT_LT(compiled.room(r).occluders.size(), all.occluders.size());
    EXPECT_EQ(compiled.room(r).own_reflectors, all.own_reflectors);
  }
}

TEST(Scene, OfAThousandRoomsOnTwentyFloorsHoldsLessThanTwentyMegabytes) {
  const Building floor = test::make_office_floor(25);
  const auto rooms = static_cast<RoomIndex>(floor.rooms.size());
  Building tower;
  for (int level = 0; level < 20; ++level) {
    for (Room room : floor.rooms) {
      room.level = level;
      tower.rooms.push_back(room);
    }
    for (Door door : floor.doors) {
      door.room_a += level * rooms;
      door.room_b += level * rooms;
      tower.doors.push_back(door);
    }
  }
  ASSERT_GT(tower.rooms.size(), 1000u);
  const scene::Scene compiled(tower, tracker::EchoModel(BeltConfig{}, {}).sight_limits());
  EXPECT_LT(compiled.memory(), 20e6);
}

}  // namespace
}  // namespace echoway
