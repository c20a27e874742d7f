#include "roaming.hpp"

#include "echoway/sim/random_walk.hpp"
#include "eval/buildings.hpp"
#include "plans.hpp"

namespace echoway::report {

Roam roam(int number, double seconds, double speed_mps) {
  constexpr int kRoomsPerSide = 4;
  const auto seed = static_cast<std::uint64_t>(number);
  Roam roam{number % 2 == 0 ? load_plan("torgersen-lab") : eval::random_office(kRoomsPerSide, 9000 + seed), {}};
  sim::RandomWalkOptions options;
  options.duration_s = seconds;
  options.speed_mps = speed_mps;
  options.random_world = false;
  roam.walk = sim::random_walk(roam.world, options, 7700 + seed);
  return roam;
}

}  // namespace echoway::report
