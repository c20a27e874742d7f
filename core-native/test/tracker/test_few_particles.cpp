// Few particles are enough while the echoes fit, and the phone's battery lasts longer for it; in doubt there are more.
#include <gtest/gtest.h>

#include <ctime>
#include <string>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

constexpr int kFew = 5, kMore = 20;                              // Particles.
constexpr std::size_t kKnown = 100, kElsewhere = 200;            // Firings from which on the wearer is known well, and
constexpr std::size_t kDoubted = 220, kBack = 260;               // from which on they hear what is heard elsewhere.
constexpr std::size_t kPasses = 10 * 15;                         // Firings later.
constexpr std::uint64_t kWalks = 4;

sim::Simulation walk_that_hears_elsewhere(const Building& building, std::uint64_t seed) {
  sim::RandomWalkOptions options;
  options.duration_s = 30.0;
  options.profile = sim::Profile::empty;
  sim::Simulation walk = *sim::simulate(building, sim::random_walk(building, options, seed));
  std::vector<Firing>& firings = walk.scans.firings;
  for (std::size_t i = kElsewhere; i < kBack; ++i) firings[i].range_m = firings[i + kPasses].range_m;
  firings.resize(kBack);
  return walk;
}

/// Of the processor, for firings that fit and for such that do not.
struct Time {
  std::clock_t known = 0, doubted = 0;
};

Time take_time(int particles) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  Time time;
  for (std::uint64_t seed = 1; seed <= kWalks; ++seed) {
    const auto walk = walk_that_hears_elsewhere(building, seed);
    const TruthRow& first = walk.truth.front();
    const Start start{building.find_room(first.room), first.pose.position, first.pose.heading};
    const BayesOptions options{.particles = particles, .parts = {.recovery = false}};
    BayesLocator locator(building, walk.scans.belt.apply_to({}), start, options);
    std::clock_t before = std::clock();
    test::play(walk, locator, [&](std::size_t i) {
      const std::clock_t now = std::clock();
      if (i >= kKnown && i < kElsewhere) time.known += now - before;
      if (i >= kDoubted) time.doubted += now - before;
      before = now;
    });
  }
  return time;
}

// At most four times a few they would take a third of the time.
TEST(FewParticles, AreAsManyInDoubtAsMoreAre) {
  const Time few = take_time(kFew), more = take_time(kMore);
  EXPECT_LT(few.known, 0.7 * static_cast<double>(more.known)) << "microseconds";
  EXPECT_GT(few.doubted, 0.6 * static_cast<double>(more.doubted)) << "microseconds";
}

}  // namespace
}  // namespace echoway
