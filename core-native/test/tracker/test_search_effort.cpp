// Far places are searched only while there is reason to: a phone's battery pays for every look.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "echoway/building/loader.hpp"
#include "echoway/sim/random_walk.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"
#include "tracker/play.hpp"

namespace echoway {
namespace {

constexpr std::size_t kFirst = 200, kSecond = 290;   // Firings from which on the belt hears what it hears elsewhere:
constexpr std::size_t kFor = 60;                     // four seconds, after which the tracker has begun to doubt;
constexpr std::size_t kLonger = 75;                  // five, after which it has looked nearby for half a second.
constexpr std::size_t kPass = 15;                    // Firings.

/// A walk through the lab that hears what is heard `passes` later twice: as among a crowd, it fits nowhere.
struct Disturbed {
  std::uint64_t seed = 1;
  std::size_t passes = 1;
};
constexpr Disturbed kWalks[] = {{2, 20}, {2, 30}, {3, 30}};

sim::Simulation disturbed_walk(const Building& building, const Disturbed& how, std::size_t second_for) {
  sim::RandomWalkOptions options;
  options.duration_s = 40.0;
  options.profile = sim::Profile::empty;
  sim::Simulation walk = *sim::simulate(building, sim::random_walk(building, options, how.seed));
  const std::vector<Firing> heard = walk.scans.firings;
  const std::size_t whole_passes = heard.size() / kPass * kPass;
  for (const auto& [from, count] : {std::pair(kFirst, kFor), std::pair(kSecond, second_for)}) {
    for (std::size_t i = from; i < from + count; ++i) {
      walk.scans.firings[i].range_m = heard[(i + how.passes * kPass) % whole_passes].range_m;
    }
  }
  return walk;
}

/// How many of a walk's firings take the processor more than 40 times as long as half of them do: a slice of a search
/// that looks far takes a hundred times as long.
std::ptrdiff_t dear_firings(const Building& building, const sim::Simulation& walk) {
  const TruthRow& first = walk.truth.front();
  const Start start{building.find_room(first.room), first.pose.position, first.pose.heading};
  BayesLocator locator(building, walk.scans.belt.apply_to({}), start, {});
  std::vector<std::clock_t> took;
  std::clock_t before = std::clock();
  test::play(walk, locator, [&](std::size_t) {
    const std::clock_t now = std::clock();
    took.push_back(now - before);
    before = now;
  });
  std::ranges::sort(took);
  const std::clock_t dear = 40 * took[took.size() / 2];
  return std::ranges::count_if(took, [&](std::clock_t one) { return one > dear; });
}

std::ptrdiff_t dear_firings_of_all(std::size_t second_for) {
  const Building building = *load_building(std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab");
  std::ptrdiff_t dear = 0;
  for (const Disturbed& how : kWalks) dear += dear_firings(building, disturbed_walk(building, how, second_for));
  return dear;
}

// Ten times as many where a doubt that is over within a second is enough to look nearby.
TEST(SearchEffort, IsNotSpentOnFarPlacesForAMomentThatFitsNowhere) { EXPECT_LT(dear_firings_of_all(kFor), 10); }

// Three times as many where what has begun goes to its end.
TEST(SearchEffort, EndsAsSoonAsTheEchoesFitAgain) { EXPECT_LT(dear_firings_of_all(kLonger), 65); }

}  // namespace
}  // namespace echoway
