#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "echoway/routing/router.hpp"
#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/sim/walk_file.hpp"
#include "import/imported.hpp"

// maps/westport-house: a real building of seven levels, as it is committed.
namespace echoway::import {
namespace {

using testing::Contains;
using testing::IsEmpty;

const std::filesystem::path kWestport = std::filesystem::path(ECHOWAY_MAPS_DIR) / "westport-house";

const Building& westport() {
  static const Building building = [] {
    Result<Building> loaded = load_building(kWestport);
    if (!loaded) ADD_FAILURE() << loaded.error().to_string();
    return loaded ? std::move(loaded).value() : Building{};
  }();
  return building;
}

/// The source as it is imported now.
const ImportedBuilding& fresh() {
  static const ImportedBuilding imported = [] {
    Report report;
    auto result = import_building(SourceFormat::wrld, kWestport / "source", report);
    if (!result) ADD_FAILURE() << result.error().to_string();
    return result ? std::move(result).value() : ImportedBuilding{};
  }();
  return imported;
}

TEST(WestportHouse, IsWhatTheImporterMakesOfItsSource) {
  const ImportedPlan plan = written_and_read(fresh());
  ASSERT_EQ(plan.building.rooms.size(), westport().rooms.size());
  for (const Room& room : plan.building.rooms) {
    const RoomIndex same = westport().find_room(room.id);
    ASSERT_NE(same, kNoRoom) << room.id;
    EXPECT_EQ(room.walls, westport().room(same).walls) << room.id << ": run make westport-house";
  }
  EXPECT_EQ(plan.building.doors.size(), westport().doors.size());
}

/// Every line that the plan draws on a level, in metres about the building's origin.
std::vector<Segment> drawn_lines(const std::string& level, const LocalProjection& projection) {
  std::ifstream file(kWestport / "source" / ("westport-house-floor-" + level + ".geojson"));
  std::vector<Segment> lines;
  const nlohmann::json plan = nlohmann::json::parse(file);
  for (const auto& feature : plan["features"]) {
    for (const auto& ring : feature["geometry"]["coordinates"]) {
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const auto at = [&](std::size_t k) { return projection.to_metres({ring[k][0], ring[k][1]}); };
        lines.push_back({at(i - 1), at(i)});
      }
    }
  }
  return lines;
}

// Thinning out vertices, closing crevices and opening doorways move no wall by more than 5 cm.
TEST(WestportHouse, EveryWallStandsWhereThePlanDrawsALine) {
  const LocalProjection projection(fresh().centre);
  const std::vector<std::string> levels{"gf", "1", "2", "3", "4", "5", "6"};
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::vector<Segment> drawn = drawn_lines(levels[level], projection);
    ASSERT_FALSE(drawn.empty());
    for (const Room& room : westport().rooms) {
      if (room.level != static_cast<int>(level)) continue;
      for (const Segment& wall : room.walls) {
        for (const double share : {0.0, 0.25, 0.5, 0.75}) {
          const Vec2 at = room.frame.transform(wall.a + share * wall.direction());
          double nearest = 1e9;
          for (const Segment& line : drawn) nearest = std::min(nearest, distance(line, at));
          EXPECT_LT(nearest, 0.05) << room.id << " at " << at.x << ", " << at.y;
        }
      }
    }
  }
}

TEST(WestportHouse, HasNothingToMend) { EXPECT_THAT(check_building(kWestport), IsEmpty()); }

TEST(WestportHouse, HasSevenLevelsOfSoundRooms) {
  std::set<int> levels;
  for (const Room& room : westport().rooms) levels.insert(room.level);
  EXPECT_EQ(levels, (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
  expect_sound(westport());
}

// From the street everybody gets to every level and almost every room; only shops with a street door of their own and
// no door to the rest of the building stand apart.
TEST(WestportHouse, EveryRoomIsReachedFromAWayOut) {
  const Building& building = westport();
  std::vector<std::set<RoomIndex>> next(building.rooms.size());
  const auto join = [&](RoomIndex a, RoomIndex b) {
    next[static_cast<std::size_t>(a)].insert(b);
    next[static_cast<std::size_t>(b)].insert(a);
  };
  for (const Door& door : building.doors) join(door.room_a, door.room_b);
  for (const LevelLink& link : building.links) join(link.room_a, link.room_b);
  std::set<RoomIndex> reached;
  std::vector<RoomIndex> open;
  for (const Landmark& exit : building.exits) open.push_back(exit.room);
  while (!open.empty()) {
    const RoomIndex room = open.back();
    open.pop_back();
    if (!reached.insert(room).second) continue;
    for (const RoomIndex beyond : next[static_cast<std::size_t>(room)]) open.push_back(beyond);
  }
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    EXPECT_THAT(reached, Contains(static_cast<RoomIndex>(i))) << building.rooms[i].id;
  }
}

TEST(WestportHouse, KnowsTheNamesOfThePlanAndItsPaths) {
  std::set<std::string> names;
  for (const Landmark& place : westport().places) names.insert(place.name);
  for (const char* name : {"Unit 4", "WRLD Office", "Main corridor", "Kitchen", "Server room", "Men's Bathroom"}) {
    EXPECT_THAT(names, Contains(name));
  }
  std::set<std::string> exits;
  for (const Landmark& exit : westport().exits) exits.insert(exit.name);
  EXPECT_THAT(exits, Contains("Bash st entrance"));
}

TEST(WestportHouse, AScanCanBeSimulatedOnEveryLevel) {
  std::set<int> heard;
  std::set<int> tried;
  for (const Landmark& place : westport().places) {
    const Room& room = westport().room(place.room);
    if (!tried.insert(room.level).second) continue;
    const auto scan =
        sim::scan_at(westport(), sim::make_world(sim::Profile::furnished), {}, {{0.0, room.id, {place.at, 0.0}}}, 1);
    ASSERT_TRUE(scan) << scan.error().to_string();
    const auto echoes =
        std::count_if(scan->firings.begin(), scan->firings.end(), [](const Firing& f) { return f.has_echo(); });
    if (echoes > 0) heard.insert(room.level);
  }
  EXPECT_EQ(heard, (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
}

/// A simulated wearer's way up two storeys.
const sim::Simulation& three_levels() {
  static const sim::Simulation simulation = [] {
    const Result<sim::Walk> walk = sim::read_walk(kWestport / "walks" / "three-levels.walk");
    Result<sim::Simulation> run = walk ? sim::simulate(westport(), *walk) : Result<sim::Simulation>(walk.error());
    if (!run) ADD_FAILURE() << run.error().to_string();
    return run ? std::move(run).value() : sim::Simulation{};
  }();
  return simulation;
}

// Through the doors and the stairs of the imported plan.
TEST(WestportHouse, AWalkLeadsOverThreeLevels) {
  ASSERT_FALSE(three_levels().truth.empty());
  std::vector<int> levels;
  for (const TruthRow& row : three_levels().truth) {
    const int level = westport().room(westport().find_room(row.room)).level;
    if (levels.empty() || levels.back() != level) levels.push_back(level);
  }
  EXPECT_EQ(levels, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(three_levels().truth.back().room, "2-wrld-office");
}

/// Mean error, metres, of the tracker on the walk over three levels while it is in the right room, the share of rows in
/// which it is, and the highest level that it ever says. Told where the walk starts; `seed`: the tracker's.
struct Followed {
  double mean_error_m = 0.0;
  double right_room = 0.0;
  int highest = 0;
  std::string last_room;
};
Followed follow_three_levels(std::uint64_t seed) {
  const sim::Simulation& run = three_levels();
  if (run.truth.empty()) return {};
  SessionConfig config;
  config.seed = seed;
  config.start = {westport().find_room(run.truth.front().room), run.truth.front().pose.position,
                  run.truth.front().pose.heading};
  auto session = Session::open(westport(), config);
  if (!session) {
    ADD_FAILURE() << session.error().to_string();
    return {};
  }
  Followed followed;
  std::size_t right = 0;
  auto hint = run.motion.begin();
  for (std::size_t i = 0; i < run.scans.firings.size(); ++i) {
    for (; hint != run.motion.end() && hint->time_s <= run.scans.firings[i].time_s; ++hint) {
      (*session)->on_motion(*hint);
    }
    (void)(*session)->on_firing(run.scans.firings[i]);
    const Estimate& e = (*session)->estimate();
    if (e.room == kNoRoom) continue;
    followed.highest = std::max(followed.highest, westport().room(e.room).level);
    followed.last_room = westport().room(e.room).id;
    if (followed.last_room != run.truth[i].room) continue;
    followed.mean_error_m += distance(e.pose.position, run.truth[i].pose.position);
    ++right;
  }
  followed.mean_error_m /= std::max<double>(1.0, static_cast<double>(right));
  followed.right_room = static_cast<double>(right) / static_cast<double>(run.scans.firings.size());
  return followed;
}

// On stairs the truth's position is the end of the link, which is all that a plan knows.
// The stairwells are alike: one wearer in a hundred is taken to have come out on another level, whichever one it is.
TEST(WestportHouse, TheTrackerFollowsTheWalkOverThreeLevels) {
  constexpr double kMeanError = 1.0;  // Metres. The stairwells and their neighbours are alike on every level ...
  constexpr double kRightRoom = 0.7;  // ... so the right one is known once the wearer comes to something that differs.
  constexpr int kTrackers = 6;
  int arrived = 0;
  for (int seed = 1; seed <= kTrackers; ++seed) {
    const Followed followed = follow_three_levels(static_cast<std::uint64_t>(seed));
    EXPECT_EQ(followed.last_room, "2-wrld-office") << "tracker of seed " << seed;
    arrived += followed.highest == 2 && followed.mean_error_m < kMeanError && followed.right_room > kRightRoom;
  }
  EXPECT_GE(arrived, kTrackers - 1);
}

// From the street door to the kitchen on the second floor and out again.
TEST(WestportHouse, RoutesLeadUpstairsAndOut) {
  const Router router(westport());
  const RoomIndex vestibule = westport().find_room("g-vestibule");
  const Result<Goal> kitchen = router.find_goal("Kitchen");
  ASSERT_TRUE(kitchen) << kitchen.error().to_string();
  const Result<Route> up = router.find_route({vestibule, {4.2, 4.2}}, *kitchen);
  ASSERT_TRUE(up) << up.error().to_string();
  const auto links = [](const Route& route) {
    return std::count_if(route.waypoints.begin(), route.waypoints.end(),
                         [](const Waypoint& w) { return w.kind == WaypointKind::link_from; });
  };
  EXPECT_GE(links(*up), 1);
  const Landmark& place = westport().places[static_cast<std::size_t>(kitchen->index)];
  const Result<Route> out = router.find_route({place.room, place.at}, Goal{Goal::Kind::nearest_exit, -1, {}});
  EXPECT_TRUE(out) << out.error().to_string();
}

}  // namespace
}  // namespace echoway::import
