#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "plans/error_of.hpp"
#include "rays/walk.hpp"
#include "tracker/play.hpp"

// A tracker that had learnt the simulator, and not the world, would lose wearers here.
namespace echoway {
namespace {

struct Errors {
  double mean_ft = 0.0;
  double worst_ft = 0.0;
};

Errors follow_walks(bool hints) {
  constexpr int kWalks = 6;
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  Errors errors;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    sim::RandomWalkOptions options;
    options.duration_s = 60.0;
    const auto walk = *sim::simulate(building, sim::random_walk(building, options, seed));
    const auto heard = rays::heard_by_rays(building, walk, seed);
    BayesLocator locator(building, heard.scans.belt.apply_to({}), test::start_of(heard, building), {.seed = seed});
    double sum_m = 0.0;
    const auto judge = [&](std::size_t i) { sum_m += plans::error_of(locator.estimate(), heard.truth[i], building); };
    test::play(heard, locator, judge, hints);
    const double mean_ft = sum_m / static_cast<double>(heard.truth.size()) / kMetresPerFoot;
    errors.mean_ft += mean_ft / kWalks;
    errors.worst_ft = std::max(errors.worst_ft, mean_ft);
  }
  return errors;
}

TEST(AmongRays, AWearerWithAPhoneIsFollowedAsThroughTheSimulator) {
  const Errors errors = follow_walks(true);
  EXPECT_LT(errors.mean_ft, 0.2);
  EXPECT_LT(errors.worst_ft, 0.45);
}

TEST(AmongRays, AWearerWithoutOneIsFollowedAsThroughTheSimulator) {
  const Errors errors = follow_walks(false);
  EXPECT_LT(errors.mean_ft, 0.5);
  EXPECT_LT(errors.worst_ft, 1.5);
}

}  // namespace
}  // namespace echoway
