#include "tracker/search_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "echoway/building/loader.hpp"
#include "support/looking.hpp"
#include "tracker/floor.hpp"
#include "tracker/panorama.hpp"
#include "tracker/plans.hpp"
#include "tracker/searching.hpp"

namespace echoway::tracker {
namespace {

constexpr double kSpacing = 0.3;

struct Place {
  RoomIndex room;
  Vec2 position;
};

class SearchGridTest : public SearchingTest {
 protected:
  SearchGridTest() : SearchingTest(test::small_office()) {}

  std::vector<Place> places(const SearchDomain& domain) {
    SearchGrid grid(kSpacing);
    grid.start(domain);
    std::vector<Place> places;
    while (grid.next(tools(), domain)) places.push_back({grid.room(), grid.position()});
    return places;
  }

  // Metres from the nearest of those tried in the room.
  static double to_nearest(const std::vector<Place>& places, RoomIndex room, Vec2 position) {
    double nearest = 1e9;
    for (const Place& p : places) {
      if (p.room == room) nearest = std::min(nearest, distance(p.position, position));
    }
    return nearest;
  }
};

TEST_F(SearchGridTest, TriesNoPlaceTwice) {
  std::set<std::tuple<RoomIndex, double, double>> seen;
  for (const Place& p : places({})) EXPECT_TRUE(seen.emplace(p.room, p.position.x, p.position.y).second);
}

TEST_F(SearchGridTest, WhereverSomebodyCanStandATriedPlaceIsNear) {
  const std::vector<Place> tried = places({});
  int stood = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto r = static_cast<RoomIndex>(i % static_cast<int>(building_.rooms.size()));
    const scene::RoomScene& room = scene_.room(r);
    const Vec2 p{random_.uniform(room.low.x, room.high.x), random_.uniform(room.low.y, room.high.y)};
    if (!can_stand(room, p)) continue;
    ++stood;
    EXPECT_LT(to_nearest(tried, r, p), 1.5 * kSpacing) << "room " << r << " at " << p.x << ", " << p.y;
  }
  EXPECT_GT(stood, 1000);
  for (const Place& p : tried) EXPECT_TRUE(can_stand(scene_.room(p.room), p.position));
}

TEST_F(SearchGridTest, TriesAllPlacesWithinReachAndNoOthers) {
  SearchDomain near;
  near.near_room = 1;
  near.near_position = 0.5 * (scene_.room(1).low + scene_.room(1).high);
  near.within = 1.5;
  const auto is_near = [&](const Place& p) {
    const Vec2 here = building_.room(p.room).frame.transform(p.position);
    return distance(here, building_.room(1).frame.transform(near.near_position)) <= 1.5;
  };
  const std::vector<Place> everywhere = places({});
  const auto within = std::count_if(everywhere.begin(), everywhere.end(), is_near);
  const std::vector<Place> tried = places(near);
  EXPECT_TRUE(std::all_of(tried.begin(), tried.end(), is_near));
  EXPECT_EQ(static_cast<std::ptrdiff_t>(tried.size()), within);
  EXPECT_GT(within, 10);
}

TEST_F(SearchGridTest, TriesOneRoomAloneWhereThatIsKnown) {
  SearchDomain told;
  told.only_room = 1;
  for (const Place& p : places(told)) EXPECT_EQ(p.room, 1);
}

constexpr const char* kSmallOffice = "small-office";

Building building_of(std::string_view name) {
  if (name == kSmallOffice) return test::small_office();
  return *load_building(std::filesystem::path(ECHOWAY_MAPS_DIR) / name);
}

struct SightsTest : SearchingTest, ::testing::WithParamInterface<const char*> {
  SightsTest() : SearchingTest(building_of(GetParam())) {}
};

TEST_P(SightsTest, WhatABlockSeesIsWhatEachOfItsPlacesSees) {
  scene::Scene cells(building_, model_.sight_limits());
  SearchGrid grid(kSpacing);
  grid.start({});
  Shot shot;
  shot.radius = belt_.radius_m;
  shot.coarse = true;
  int compared = 0;
  for (int n = 0; grid.next(tools(), {}); ++n) {
    if (n % 7 != 0) continue;
    for (int k = 0; k < Panorama::kDirections; ++k) {
      const double heading = wrap_near(kTwoPi * k / Panorama::kDirections);
      const Particle p = test::standing(grid.room(), grid.position(), heading);
      const ExpectedEchoes seen = expect_from(grid.seen(tools()), scene_.room(p.room), p, shot, model_);
      SCOPED_TRACE(::testing::Message() << "room " << p.room << " at " << p.position.x << ", " << p.position.y
                                        << " heading " << p.heading);
      ASSERT_NO_FATAL_FAILURE(test::expect_same(seen, expect(p, shot, model_, cells)));
      compared += seen.count;
    }
  }
  EXPECT_GT(compared, 1000);
}

INSTANTIATE_TEST_SUITE_P(Buildings, SightsTest,
                         ::testing::Values(kSmallOffice, "two-rooms", "similar-rooms", "torgersen-lab"),
                         [](const auto& name) {
                           std::string said = name.param;
                           std::ranges::replace(said, '-', '_');
                           return said;
                         });

}  // namespace
}  // namespace echoway::tracker
