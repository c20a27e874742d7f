#include "echoway/routing/router.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "echoway/random.hpp"
#include "support/plans.hpp"

namespace echoway {
namespace {

using test::add_door;
using test::add_pillar;
using test::make_box;
using test::make_grid;
using test::make_office_floor;
using test::make_room;
using ::testing::HasSubstr;

Goal spot(RoomIndex room, Vec2 at) { return {Goal::Kind::spot, 0, {room, at}}; }

/// The least distance that the walked way keeps from anything solid, doorways (0.6 m about a door) left out.
double least_clearance(const Router& router, const Route& route) {
  double least = 1e9;
  for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
    const Waypoint& last = route.waypoints[i - 1];
    const Waypoint& here = route.waypoints[i];
    if (here.kind == WaypointKind::link_to) continue;
    const bool from_door = last.kind == WaypointKind::door;
    const Vec2 from = from_door ? last.next_at : last.at;
    for (int k = 0; k <= 200; ++k) {
      const Vec2 p = from + (k / 200.0) * (here.at - from);
      if (from_door && distance(p, from) < 0.6) continue;
      if (here.kind == WaypointKind::door && distance(p, here.at) < 0.6) continue;
      least = std::min(least, router.space(here.room).clearance(p));
    }
  }
  return least;
}

TEST(Router, GoesStraightWhereNothingIsInTheWay) {
  Building b;
  b.rooms.push_back(make_box("1", 8, 6));
  const Router router(b);
  const auto route = router.find_route({0, {1, 1}}, spot(0, {6, 5}));
  ASSERT_TRUE(route);
  EXPECT_EQ(route->waypoints.size(), 2U);
  EXPECT_NEAR(route->length_m, std::hypot(5, 4), 1e-12);
}

TEST(Router, TurnsAboutAReflexCornerAtTheWalkersHalfWidth) {
  // An L: the shortest way for a disc of radius r is two tangents and a quarter arc about the inner corner.
  Building b;
  b.rooms.push_back(make_room("1", {{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}));
  const Router router(b);
  const auto route = router.find_route({0, {2, 9}}, spot(0, {9, 2}));
  ASSERT_TRUE(route);
  const auto shortest = [](double r) {
    const double reach = std::hypot(5, 2);
    const double around = kTwoPi - std::acos(-20.0 / 29.0);  // from corner->start to corner->goal on the free side
    return 2 * std::sqrt(reach * reach - r * r) + r * (around - 2 * std::acos(r / reach));
  };
  const double r = router.config().clearances[0].radius;
  EXPECT_GE(route->length_m, shortest(r) - 1e-9);
  EXPECT_LE(route->length_m, shortest(r / std::cos(kPi / 8)) + 1e-9);
  EXPECT_GE(least_clearance(router, *route), r - 1e-5);
  EXPECT_FALSE(route->narrow(router.config()));
}

TEST(Router, PassesThroughDoorCentresAndSquareToThem) {
  const Building b = make_grid(2, 1);
  const Router router(b);
  const auto route = router.find_route({0, {1, 4.5}}, spot(1, {4, 4.5}));
  ASSERT_TRUE(route);
  const auto door = std::find_if(route->waypoints.begin(), route->waypoints.end(),
                                 [](const Waypoint& w) { return w.kind == WaypointKind::door; });
  ASSERT_NE(door, route->waypoints.end());
  EXPECT_EQ(door->next_room, 1);
  EXPECT_NEAR(distance(door->at, Vec2{5, 2.5}), 0.0, 1e-9);
  EXPECT_NEAR((door - 1)->at.y, 2.5, 1e-9);
  EXPECT_NEAR((door + 1)->at.y, 2.5, 1e-9);
}

TEST(Router, KeepsItsClearanceInRandomClutter) {
  Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    Building b;
    b.rooms.push_back(make_box("1", 12, 9));
    for (int i = 0; i < 8; ++i) {
      const Vec2 p{random.uniform(1.5, 10), random.uniform(1.5, 7)};
      const Vec2 towards = unit_from_angle(random.uniform(-kPi, kPi));
      const Vec2 q = p + random.uniform(0.4, 1.5) * towards;
      b.rooms[0].reflectors.push_back({p, q});
    }
    const Router router(b);
    const auto route = router.find_route({0, {0.6, 0.6}}, spot(0, {11.4, 8.4}));
    ASSERT_TRUE(route) << trial;
    EXPECT_GE(least_clearance(router, *route), route->clearance_m - 1e-5) << trial;
    EXPECT_GE(route->length_m, distance(Vec2{0.6, 0.6}, Vec2{11.4, 8.4}) - 1e-9);
  }
}

TEST(Router, SlalomsAroundScreensByTheShortestSide) {
  Building b;
  b.rooms.push_back(make_box("1", 8, 6));
  b.rooms[0].reflectors.push_back({{3, 0}, {3, 4}});
  b.rooms[0].reflectors.push_back({{5, 6}, {5, 2}});
  const Router router(b);
  const Vec2 from{1, 1};
  const Vec2 to{7, 5};
  const auto route = router.find_route({0, from}, spot(0, to));
  ASSERT_TRUE(route);
  const double r = router.config().clearances[0].radius;
  const double around_first = std::hypot(3 - 1, 4 + r - 1);
  const double lower_bound = around_first + distance(Vec2{3, 4 + r}, Vec2{5, 2 - r}) + distance(Vec2{5, 2 - r}, to);
  EXPECT_GE(route->length_m, lower_bound - 1e-9);
  EXPECT_LE(route->length_m, lower_bound * 1.05);
}

TEST(Router, TakesTheNarrowGapWhenThereIsNoOtherWayAndSaysSo) {
  Building b;
  b.rooms.push_back(make_box("1", 8, 4));
  b.rooms[0].reflectors.push_back({{4, 0}, {4, 1.7}});
  b.rooms[0].reflectors.push_back({{4, 2.3}, {4, 4}});
  b.places.push_back({0, {1, 2}, "Desk"});
  b.places.push_back({0, {7, 2}, "Sofa"});
  add_door(b, 0, {0, 2}, 1, {2, 2});
  add_door(b, 0, {8, 2}, 2, {0, 2});
  b.rooms.push_back(make_box("2", 2, 4));
  b.rooms.push_back(make_box("3", 2, 4));
  const Router router(b);
  const auto route = router.find_route({1, {1, 2}}, spot(2, {1, 2}));
  ASSERT_TRUE(route) << route.error().message;
  EXPECT_TRUE(route->narrow(router.config()));
  EXPECT_GE(least_clearance(router, *route), router.config().clearances.back().radius - 1e-5);
}

TEST(Router, NeverGoesThroughAGapThatIsTooNarrow) {
  Building b;
  b.rooms.push_back(make_box("1", 8, 4));
  b.rooms[0].reflectors.push_back({{4, 0}, {4, 1.8}});
  b.rooms[0].reflectors.push_back({{4, 2.2}, {4, 4}});
  const Router router(b);
  const auto route = router.find_route({0, {1, 2}}, spot(0, {7, 2}));
  ASSERT_FALSE(route);
  EXPECT_THAT(route.error().message, HasSubstr("no safe way"));
}

TEST(Router, SaysWhenRoomsAreNotJoined) {
  Building b;
  b.rooms.push_back(make_box("1", 4, 4));
  b.rooms.push_back(make_box("2", 4, 4));
  const Router router(b);
  const auto route = router.find_route({0, {1, 2}}, {Goal::Kind::spot, 0, {1, {2, 2}}});
  ASSERT_FALSE(route);
  EXPECT_THAT(route.error().message, HasSubstr("room 1"));
  EXPECT_THAT(route.error().message, HasSubstr("room 2"));
}

TEST(Router, KeepsToTheDoorThatAWalkerIsBoundForUnlessAnotherSavesMuch) {
  // Two doors lead from the lower to the upper room; the walker stands a little nearer to the left one.
  Building b;
  b.rooms.push_back(make_box("below", 10, 4));
  b.rooms.push_back(make_box("above", 10, 4));
  add_door(b, 0, {2, 4}, 1, {2, 0});
  add_door(b, 0, {8, 4}, 1, {8, 0});
  const Router router(b);
  const auto tree = router.tree_to(spot(1, {5, 2}));
  ASSERT_TRUE(tree);
  const auto first_door = [&](Vec2 from, const BoundFor& bound_for) {
    Route route;
    EXPECT_TRUE(router.route_from({0, from}, *tree, route, bound_for));
    const auto door = std::find_if(route.waypoints.begin(), route.waypoints.end(),
                                   [](const Waypoint& w) { return w.kind == WaypointKind::door; });
    return door == route.waypoints.end() ? -1 : door->index;
  };
  const BoundFor right{WaypointKind::door, 1, 1.0};
  EXPECT_EQ(first_door({4.8, 2}, {}), 0);
  EXPECT_EQ(first_door({4.8, 2}, right), 1);
  EXPECT_EQ(first_door({3.0, 2}, right), 0);
}

TEST(Router, PrefersTheElevatorWhenStairsAreToBeAvoided) {
  Building b;
  b.rooms.push_back(make_box("1", 20, 3));
  b.rooms.push_back(make_box("2", 20, 3));
  b.rooms[1].level = 1;
  b.links.push_back({LevelLinkKind::stairs, 0, {3, 1.5}, 1, {3, 1.5}});
  b.links.push_back({LevelLinkKind::elevator, 0, {18, 1.5}, 1, {18, 1.5}});
  const Router router(b);
  const auto quick = router.find_route({0, {1, 1.5}}, spot(1, {5, 1.5}));
  const auto level = router.find_route({0, {1, 1.5}}, spot(1, {5, 1.5}), {.avoid_stairs = true});
  ASSERT_TRUE(quick);
  ASSERT_TRUE(level);
  EXPECT_TRUE(quick->uses_stairs);
  EXPECT_FALSE(level->uses_stairs);
  EXPECT_TRUE(level->uses_elevator);
  EXPECT_GT(walked_length(*level), walked_length(*quick));
}

TEST(Router, StillTakesStairsWhenNothingElseLeadsThere) {
  Building b;
  b.rooms.push_back(make_box("1", 6, 3));
  b.rooms.push_back(make_box("2", 6, 3));
  b.links.push_back({LevelLinkKind::stairs, 0, {3, 1.5}, 1, {3, 1.5}});
  const Router router(b);
  const auto route = router.find_route({0, {1, 1.5}}, spot(1, {5, 1.5}), {.avoid_stairs = true});
  ASSERT_TRUE(route);
  EXPECT_TRUE(route->uses_stairs);
}

TEST(Router, FindsTheNearestExitByWalkingNotByAir) {
  // The exit behind the wall is nearer by air.
  Building b;
  b.rooms.push_back(make_box("1", 10, 10));
  b.rooms[0].reflectors.push_back({{0, 5}, {9, 5}});
  b.exits.push_back({0, {1, 10}, "north"});
  b.exits.push_back({0, {10, 1}, "east"});
  const Router router(b);
  const auto route = router.find_route({0, {1, 3}}, {Goal::Kind::nearest_exit, -1, {}});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->goal.kind, Goal::Kind::exit);
  EXPECT_EQ(route->goal.index, 1);
}

TEST(Router, ARoomIsReachedJustInsideItsDoor) {
  const Building b = make_office_floor(3);
  const Router router(b);
  const auto route = router.find_route({1, {1, 3}}, {Goal::Kind::room, 3, {}});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->waypoints.back().room, 3);
  EXPECT_LE(route->waypoints.back().at.y, 0.8 + 1e-9);
  const auto inside = router.find_route({3, {2, 2}}, {Goal::Kind::room, 3, {}});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->length_m, 0.0, 1e-12);
}

TEST(Router, LeavesAWallThatItIsToldToStartIn) {
  const Building b = make_grid(2, 1);
  const Router router(b);
  for (const Vec2 start : {Vec2{-0.2, 2}, Vec2{0, 0}, Vec2{5.1, 2.5}, Vec2{5, 4.99}, Vec2{2.5, 5.3}}) {
    const auto route = router.find_route({0, start}, spot(1, {4, 4}));
    ASSERT_TRUE(route) << start.x << ' ' << start.y;
    EXPECT_LT(route->length_m, 12.0);
  }
}

TEST(Router, LeadsOutOfAGapThatJustLetsAWalkerThroughFromAnywhereInIt) {
  Building b;
  b.rooms.push_back(make_box("1", 5, 4));
  b.rooms[0].reflectors.push_back({{0.5, 2.5}, {1.5, 2.5}});
  const Router router(b);
  for (double x = 0.02; x < 0.5; x += 0.02) {
    for (double y = 2.21; y < 2.8; y += 0.02) {
      EXPECT_TRUE(router.find_route({0, {x, y}}, spot(0, {4, 1}))) << x << ' ' << y;
    }
  }
}

TEST(Router, ReachesAPlaceThatStandsAgainstAWall) {
  Building b;
  b.rooms.push_back(make_box("1", 6, 6));
  b.places.push_back({0, {6, 3}, "Window"});
  b.places.push_back({0, {0.05, 0.05}, "Corner"});
  const Router router(b);
  for (const std::int32_t place : {0, 1}) {
    const auto route = router.find_route({0, {2, 2}}, {Goal::Kind::place, place, {}});
    ASSERT_TRUE(route);
    EXPECT_LT(distance(route->waypoints.back().at, b.places[static_cast<std::size_t>(place)].at), 0.7);
    EXPECT_GE(least_clearance(router, *route), 0.44);
  }
}

TEST(Router, CopesWithDoorsOffTheirWallsAndOverlappingRooms) {
  Building b = make_grid(3, 1);
  b.doors[0].at_a = {4.8, 2.4};
  b.doors[0].at_b = {-0.15, 2.55};
  b.doors[1].at_a = {5.2, 2.5};
  b.rooms[1].frame.position.x -= 0.6;
  const Router router(b);
  const auto route = router.find_route({0, {1, 1}}, spot(2, {4, 4}));
  ASSERT_TRUE(route) << route.error().message;
  EXPECT_EQ(std::count_if(route->waypoints.begin(), route->waypoints.end(),
                          [](const Waypoint& w) { return w.kind == WaypointKind::door; }),
            2);
}

TEST(Router, RefusesWhatIsNotFiniteOrNotThere) {
  const Building b = make_grid(2, 1);
  const Router router(b);
  const double nan = std::nan("");
  EXPECT_FALSE(router.find_route({0, {nan, 1}}, spot(1, {1, 1})));
  EXPECT_FALSE(router.find_route({0, {1, 1}}, spot(1, {nan, 1})));
  EXPECT_FALSE(router.find_route({7, {1, 1}}, spot(1, {1, 1})));
  EXPECT_FALSE(router.find_route({0, {1, 1}}, {Goal::Kind::place, 3, {}}));
  EXPECT_FALSE(router.find_route({0, {1, 1}}, {Goal::Kind::nearest_exit, -1, {}}));
}

TEST(Router, TellsNoInfiniteClearanceOfAWayThatIsNone) {
  const Building b = make_grid(2, 1);
  const Router router(b);
  const Result<RouteTree> tree = router.tree_to({Goal::Kind::room, 0, {}});
  ASSERT_TRUE(tree);
  Route route;
  ASSERT_TRUE(router.route_from({0, {1, 1}}, *tree, route));  // there already
  EXPECT_TRUE(std::isfinite(route.clearance_m));
  EXPECT_FALSE(route.narrow(router.config()));
  EXPECT_FALSE(router.route_from({7, {1, 1}}, *tree, route));
  EXPECT_TRUE(route.waypoints.empty());
  EXPECT_EQ(route.clearance_m, 0.0);
  route.clear();
  EXPECT_EQ(route.clearance_m, 0.0);
}

TEST(Router, FindsGoalsByWhatWearersSay) {
  Building b = make_grid(2, 1);
  b.rooms[1].name = "Seminar room";
  b.places.push_back({1, {2, 2}, "Lectern"});
  b.exits.push_back({0, {0, 2}, "Main entrance"});
  const Router router(b);
  EXPECT_EQ(router.find_goal(" lectern ")->kind, Goal::Kind::place);
  EXPECT_EQ(router.find_goal("Main Entrance")->kind, Goal::Kind::exit);
  EXPECT_EQ(router.find_goal("seminar ROOM")->index, 1);
  EXPECT_EQ(router.find_goal("room 1")->index, 1);
  EXPECT_EQ(router.find_goal("exit")->kind, Goal::Kind::nearest_exit);
  const auto none = router.find_goal("Kitchen");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("Lectern"));
}

TEST(Router, NamesTheRoomThatNothingLeadsInto) {
  Building b = make_grid(2, 1);
  b.rooms.push_back(make_box("store", 2, 2));
  const Router router(b);
  const auto store = router.tree_to({Goal::Kind::room, 2, {}});
  ASSERT_TRUE(store);
  const Status none = router.check_goal(*store, 0);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("nothing leads into room store: no door"));
  EXPECT_FALSE(router.tree_to({Goal::Kind::room, 7, {}}));
}

TEST(Router, WhoIsInARoomThatNothingLeadsIntoHasArrived) {
  Building b = make_grid(2, 1);
  b.rooms.push_back(make_box("store", 2, 2));
  const Router router(b);
  const auto store = router.tree_to({Goal::Kind::room, 2, {}});
  ASSERT_TRUE(store);
  EXPECT_TRUE(router.check_goal(*store, 2));
  const auto route = router.find_route({2, {0.5, 1.5}}, {Goal::Kind::room, 2, {}});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->length_m, 0.0);
  EXPECT_FALSE(router.find_route({0, {2, 2}}, {Goal::Kind::room, 2, {}}));
}

TEST(Router, ABuildingOfOneRoomIsWhereItsWearerIs) {
  Building b;
  b.rooms.push_back(make_box("hall", 6, 4));
  const Router router(b);
  const auto hall = router.tree_to({Goal::Kind::room, 0, {}});
  ASSERT_TRUE(hall);
  EXPECT_TRUE(router.check_goal(*hall));
}

TEST(Router, LeadsThroughNoDoorThatNobodyPasses) {
  // A slit of 0.25 m would be the short way; the long one leads through the room above.
  Building b;
  for (const char* id : {"1", "2"}) b.rooms.push_back(make_box(id, 4, 4));
  b.rooms.push_back(make_box("above", 8, 4));
  b.unit = LengthUnit::metres;
  add_door(b, 0, {4, 1}, 1, {0, 1}, 0.25);
  add_door(b, 0, {2, 4}, 2, {2, 0});
  add_door(b, 1, {2, 4}, 2, {6, 0});
  const Router round(b);
  const auto route = round.find_route({0, {3, 1}}, spot(1, {1, 1}));
  ASSERT_TRUE(route);
  for (const Waypoint& w : route->waypoints) EXPECT_FALSE(w.kind == WaypointKind::door && w.index == 0);

  // With the door above locked as well, nothing is left but the slit.
  b.doors.pop_back();
  const Router closed(b);
  const auto tree = closed.tree_to({Goal::Kind::room, 1, {}});
  ASSERT_TRUE(tree);
  const Status goal = closed.check_goal(*tree, 0);
  ASSERT_FALSE(goal);
  EXPECT_THAT(goal.error().message,
              HasSubstr("nothing leads into room 2: the door between rooms '1' and '2' is 0.25 m wide"));
  EXPECT_FALSE(closed.find_route({0, {3, 1}}, spot(1, {1, 1})));
}

TEST(Router, SaysWhatIsBetweenRoomsThatNoWayJoins) {
  Building b = make_grid(4, 1);
  b.unit = LengthUnit::metres;
  b.doors[1].width = 0.3;
  const Goal far{Goal::Kind::room, 3, {}};
  const auto why = [&](std::optional<Vec2> at) {
    const Router router(b);
    const auto tree = router.tree_to(far);
    const Status way = router.check_way(0, at, *tree);
    return way ? std::string() : way.error().message;
  };
  for (const std::optional<Vec2> at : {std::optional<Vec2>(), std::optional<Vec2>({1, 1})}) {
    EXPECT_THAT(
        why(at),
        HasSubstr("from room 0 to the destination in room 3: the door between rooms '1' and '2' is 0.3 m wide"));
  }
  b.doors[1].width = 0.9;
  EXPECT_EQ(why(Vec2{1, 1}), "");
  // Shelves across the room leave a gap of 0.3 m. In which half somebody stands who says no more than the room is not
  // known.
  b.rooms[0].reflectors = {{{3, 0}, {3, 2.4}}, {{3, 2.7}, {3, 5}}};
  EXPECT_THAT(why(Vec2{1, 1}), HasSubstr("what is free on the way is narrower than 0.5 m"));
  EXPECT_EQ(why(std::nullopt), "");
  b.doors.erase(b.doors.begin() + 1);
  EXPECT_THAT(why(Vec2{4, 2}), HasSubstr("no doors, stairs or elevators join them"));
}

TEST(Router, ATriangleOfWaysNeverBreaksTheTriangleInequality) {
  // Shortest ways: going over any third place is never shorter than going straight there.
  const Building b = make_office_floor(4);
  const Router router(b);
  Random random(3);
  const auto anywhere = [&] {
    const auto room = static_cast<RoomIndex>(random.uniform(0, static_cast<double>(b.rooms.size())));
    return room == 0 ? Spot{0, {random.uniform(0.6, 15), random.uniform(0.6, 1.8)}}
                     : Spot{room, {random.uniform(0.6, 3.4), random.uniform(0.6, 3.4)}};
  };
  for (int i = 0; i < 50; ++i) {
    const Spot p = anywhere();
    const Spot q = anywhere();
    const Spot r = anywhere();
    const double pq = router.find_route(p, spot(q.room, q.at))->length_m;
    const double qr = router.find_route(q, spot(r.room, r.at))->length_m;
    const double pr = router.find_route(p, spot(r.room, r.at))->length_m;
    EXPECT_LE(pr, (pq + qr) * 1.02 + 0.05) << i;
  }
}

TEST(Router, RetracesCrumbsWithoutTheirLoops) {
  const Building b = make_grid(3, 3);
  const Router router(b);
  std::vector<Spot> crumbs;
  // Out of room 0, a loop through rooms 1, 4, 3 back to 0, then on to 1.
  for (const Spot s : {Spot{0, {1, 1}}, Spot{0, {2.5, 2.5}}, Spot{1, {2.5, 2.5}}, Spot{4, {2.5, 2.5}},
                       Spot{3, {2.5, 2.5}}, Spot{0, {2.5, 2.6}}, Spot{1, {2.5, 2.4}}}) {
    crumbs.push_back(s);
  }
  const auto back = router.retrace({1, {4, 4}}, crumbs);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->waypoints.back().room, 0);
  EXPECT_NEAR(distance(back->waypoints.back().at, Vec2{1, 1}), 0.0, 1e-9);
  for (const Waypoint& w : back->waypoints) EXPECT_LE(w.room, 1);
  EXPECT_LT(back->length_m, 9.5);
  EXPECT_GE(least_clearance(router, *back), 0.24);
}

TEST(Router, GivesTheSameRouteOnEveryRun) {
  const Building b = make_office_floor(6);
  const Router one(b);
  const Router two(b);
  const auto a = one.find_route({2, {1, 1}}, spot(9, {3, 3}));
  const auto c = two.find_route({2, {1, 1}}, spot(9, {3, 3}));
  ASSERT_EQ(a->waypoints.size(), c->waypoints.size());
  for (std::size_t i = 0; i < a->waypoints.size(); ++i) EXPECT_EQ(a->waypoints[i].at, c->waypoints[i].at);
}

}  // namespace
}  // namespace echoway
