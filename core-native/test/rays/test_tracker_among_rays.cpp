#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "rays/walk.hpp"
#include "report/following.hpp"

// A tracker that had learnt the simulator, and not the world, would lose wearers here.
namespace echoway {
namespace {

struct Errors {
  double mean_ft = 0.0;
  double worst_ft = 0.0;
};

Errors follow_walks(const report::Estimator& estimator) {
  constexpr int kWalks = 6;
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  Errors errors;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    sim::RandomWalkOptions options;
    options.duration_s = 60.0;
    const auto walk = *sim::simulate(building, sim::random_walk(building, options, seed));
    const auto heard = rays::heard_by_rays(building, walk, seed);
    const report::Track track = report::follow({building, building, heard, kReferenceCelsius, seed}, estimator);
    const double mean_ft = report::summarise(track).mean_m / kMetresPerFoot;
    errors.mean_ft += mean_ft / kWalks;
    errors.worst_ft = std::max(errors.worst_ft, mean_ft);
  }
  return errors;
}

TEST(AmongRays, AWearerWithAPhoneIsFollowedAsThroughTheSimulator) {
  const Errors errors = follow_walks(report::tracker());
  EXPECT_LT(errors.mean_ft, 0.2);
  EXPECT_LT(errors.worst_ft, 0.45);
}

TEST(AmongRays, AWearerWithoutOneIsFollowedAsThroughTheSimulator) {
  const Errors errors = follow_walks(report::tracker_without_hints());
  EXPECT_LT(errors.mean_ft, 0.5);
  EXPECT_LT(errors.worst_ft, 1.5);
}

}  // namespace
}  // namespace echoway
