#include "scene/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "echoway/random.hpp"
#include "echoway/scene/scene_report.hpp"
#include "scene/scene.hpp"
#include "support/plans.hpp"
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

// Every reflector of the room in every direction, with everything that blocks sight in between: nothing is left out.
scene::Cell whole_room(const scene::RoomScene& room) {
  scene::Cell cell;
  EXPECT_LE(room.occluders.size(), cell.occluders.size());
  EXPECT_LE(room.reflectors.size(), cell.entries.size());
  for (std::size_t k = 0; k < room.occluders.size(); ++k) cell.occluders[k] = static_cast<std::uint16_t>(k);
  for (std::size_t i = 0; i < room.reflectors.size(); ++i) {
    cell.entries[i] = {static_cast<std::uint16_t>(i), 0, static_cast<std::uint16_t>(room.occluders.size())};
    cell.items[i] = static_cast<std::uint8_t>(i);
  }
  return cell;
}

// The list serves one firing: all of it stands in the sector into which `shot` goes.
ExpectedEchoes expect_from_all(scene::Cell& cell, const scene::RoomScene& room, const tracker::Particle& p,
                               const tracker::Shot& shot, const tracker::EchoModel& model) {
  const double part = p.heading / kTwoPi - std::floor(p.heading / kTwoPi);
  const auto sector = static_cast<std::size_t>(part * scene::Cell::kSectors);
  for (std::size_t s = 0; s <= scene::Cell::kSectors; ++s) {
    cell.sector_begin[s] = s <= sector ? std::uint16_t{0} : static_cast<std::uint16_t>(room.reflectors.size());
  }
  return tracker::expect_from(cell, room, p, shot, model);
}

TEST(Cell, LeavingOutWhatAPlaceCannotHearChangesNoEcho) {
  const Building building = furnished_office();
  const BeltConfig belt;
  const tracker::EchoModel model(belt, {});
  scene::Scene compiled(building, model.sight_limits());
  const scene::RoomCompiler compiler(building, model.sight_limits().max_range, scene::kCellSize);
  std::vector<scene::RoomScene> whole_rooms;
  std::vector<scene::Cell> whole;
  for (std::size_t r = 0; r < compiler.rooms(); ++r) {
    whole_rooms.push_back(compiler.compile(static_cast<RoomIndex>(r)));
    whole.push_back(whole_room(whole_rooms.back()));
  }
  Random random(4);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    tracker::Particle p;
    p.room = static_cast<RoomIndex>(random.next() % building.rooms.size());
    const auto& room = compiled.room(p.room);
    p.position = {random.uniform(room.low.x, room.high.x), random.uniform(room.low.y, room.high.y)};
    if (!room.floor.contains(p.position) || room.floor.distance(p.position) < 0.2) continue;
    p.heading = random.uniform(-kPi, kPi);
    const auto facing = tracker::fast_sincos(p.heading);
    p.facing = {facing.cos, facing.sin};
    tracker::Shot shot;
    shot.radius = belt.radius_m;
    shot.coarse = i % 3 == 0;
    const ExpectedEchoes some = tracker::expect(p, shot, model, compiled);
    const auto r = static_cast<std::size_t>(p.room);
    const ExpectedEchoes all = expect_from_all(whole[r], whole_rooms[r], p, shot, model);
    ASSERT_EQ(some.count, all.count) << "room " << p.room << " at " << p.position.x << ", " << p.position.y << " heading " << p.heading;
    for (int k = 0; k < some.count; ++k) {
      const auto& a = some.echo[static_cast<std::size_t>(k)];
      const auto& b = all.echo[static_cast<std::size_t>(k)];
      ASSERT_EQ(a.range, b.range);
      ASSERT_EQ(a.chance, b.chance);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

void add_ring(Room& room, Vec2 centre, double radius, int screens) {
  for (int i = 0; i < screens; ++i) {
    const Vec2 out = unit_from_angle(kTwoPi * i / screens);
    const Vec2 along = 0.09 * perpendicular(out);
    const Vec2 at = centre + radius * out;
    room.walls.push_back({at - along, at + along});
  }
}

TEST(Cell, TooFullForAllThatMayAnswerLeavesOutTheFarthest) {
  Building building;
  building.rooms.push_back(test::make_box("screens", 10.0, 10.0));
  const Vec2 centre{4.95, 4.95};
  add_ring(building.rooms[0], centre, 1.4, 36);
  add_ring(building.rooms[0], centre, 2.4, 24);
  const tracker::EchoModel model(BeltConfig{}, {});
  scene::Scene compiled(building, model.sight_limits());
  const scene::RoomScene& room = compiled.room(0);
  scene::Cell whole = whole_room(room);
  for (int i = 0; i < 180; ++i) {
    tracker::Particle p;
    p.room = 0;
    p.position = centre;
    p.heading = kTwoPi * i / 180;
    p.facing = unit_from_angle(p.heading);
    const ExpectedEchoes some = tracker::expect(p, {}, model, compiled);
    const ExpectedEchoes all = expect_from_all(whole, room, p, {}, model);
    ASSERT_GT(all.count, 0);
    ASSERT_GT(some.count, 0) << "heading " << p.heading;
    EXPECT_EQ(some.echo[0].range, all.echo[0].range) << "heading " << p.heading;
  }
}

TEST(SceneReport, SaysWhatARoomDoesNotNeed) {
  const Building building = furnished_office();
  const SceneReport report = report_scene(building, {});
  ASSERT_EQ(report.rooms.size(), building.rooms.size());
  EXPECT_FALSE(report.levels);
  EXPECT_TRUE(report.rooms[1].all_reflective);
  for (const RoomSavings& r : report.rooms) {
    EXPECT_LT(r.considered, 0.5 * static_cast<double>(r.reflectors));
    EXPECT_LT(r.hidden_tests, r.considered * static_cast<double>(r.occluders));
  }
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
