#include "tracker/panorama.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/looking.hpp"
#include "tracker/plans.hpp"

namespace echoway::tracker {
namespace {

constexpr Vec2 kBeside{0.2, 0.2};   // Farther from a place than the belt about it.

TEST(Panorama, ExpectsWhatTheTrackerExpectsThere) {
  const Building building = test::small_office();
  const BeltConfig belt;
  const EchoModel model(belt, {});
  scene::Scene scene(building, model.sight_limits());
  scene::Scene looked_at(building, model.sight_limits());
  Panorama panorama;
  for (RoomIndex room = 0; room < static_cast<RoomIndex>(building.rooms.size()); ++room) {
    const Vec2 place = 0.5 * (scene.room(room).low + scene.room(room).high) + Vec2{0.31, -0.17};
    panorama.stand_at(looked_at.room(room), place);
    const scene::Cell visible = looked_at.seen_from(room, place - kBeside, place + kBeside);
    for (int k = 0; k < Panorama::kDirections; ++k) {
      const double angle = wrap_near(kTwoPi * k / Panorama::kDirections);
      const Particle p = test::standing(room, place, angle);
      Shot shot;
      shot.radius = belt.radius_m;
      shot.coarse = true;
      for (const double range : {0.0, 0.8, 1.7, 3.2}) {
        shot.echo = range > 0.0;
        shot.range = range;
        const double exact = weigh(p, shot, model, scene).density;
        const Panorama::Sight& sight = panorama.towards(angle, belt.radius_m, model, visible);
        const double seen = density_of(sight, shot.echo, range, {}, model);
        EXPECT_NEAR(seen, exact, 1e-9 * exact) << "room " << room << ", direction " << k << ", range " << range;
      }
    }
  }
}

TEST(Panorama, FollowsAShortWalkTowardsAWall) {
  const Building building = test::small_office();
  const BeltConfig belt;
  const EchoModel model(belt, {});
  scene::Scene scene(building, model.sight_limits());
  const auto& room = scene.room(1);
  const Vec2 place{0.5 * (room.low.x + room.high.x), room.low.y + 1.5};
  Panorama panorama;
  panorama.stand_at(room, place);
  const scene::Cell visible = scene.seen_from(1, place - kBeside, place + kBeside);
  const Panorama::Sight& sight = panorama.towards(-0.5 * kPi, belt.radius_m, model, visible);
  Offset walked;
  walked.moved = {0.0, -0.4};
  const double to_wall = 1.5 - belt.radius_m;
  EXPECT_GT(density_of(sight, true, to_wall - 0.4, walked, model),
            5.0 * density_of(sight, true, to_wall, walked, model));
  EXPECT_GT(density_of(sight, true, to_wall, {}, model), 5.0 * density_of(sight, true, to_wall - 0.4, {}, model));
}

}  // namespace
}  // namespace echoway::tracker
