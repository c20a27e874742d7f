// The proof of guidance: blindfolded wearers walk through buildings by cues alone. One row a walk, as CSV,
// behind what the files hold already.
//   guidance_proof OUT.csv TRACES.csv WALKS SOURCE MAP...
// WALKS: how many; or A-B for walks A to B - 1; or #N for walk N alone, with its diary on the standard output.
// SOURCE: noise (truth with 0.12 m and 4 degrees of drifting error), empty or furnished (the tracker on the simulated
// world's echoes, told where the walk starts), search (the tracker told nothing, in a furnished world), cluttered (as
// furnished, but things stand on the way as well), obstacles (the same with the noisy truth instead of the tracker). A
// MAP is a building's folder, or office, grid, levels for one made here.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>

#include "guided_walk.hpp"
#include "made_building.hpp"
#include "traces.hpp"

namespace {

/// The first walk and the one after the last.
std::pair<int, int> walks_of(const std::string& which) {
  const bool one = which.front() == '#';
  const int number = std::atoi(which.c_str() + (one ? 1 : 0));
  if (one) return {number, number + 1};
  const std::size_t dash = which.find('-');
  return dash == std::string::npos ? std::pair{0, number} : std::pair{number, std::atoi(which.c_str() + dash + 1)};
}

constexpr std::array kSources{"noise", "empty", "furnished", "search", "cluttered", "obstacles"};

int run(int argc, char** argv) {
  using namespace echoway;
  if (argc < 6) {
    std::fprintf(stderr, "usage: guidance_proof OUT.csv TRACES.csv WALKS SOURCE MAP...\n");
    return 2;
  }
  const std::string which = argv[3];
  const std::string source = argv[4];
  if (std::ranges::find(kSources, source) == kSources.end()) {
    fmt::print(stderr, "guidance_proof: SOURCE {} is none of {}\n", source, fmt::join(kSources, ", "));
    return 2;
  }
  proof::Files out{{argv[1], proof::kWalkColumns}, {argv[2], proof::kTraceColumns}, which.front() == '#'};
  const auto [first, last] = walks_of(which);
  for (int i = 5; i < argc; ++i) {
    std::string name = argv[i];
    const Result<Building> building = proof::building_of(name);
    if (!building) {
      std::fprintf(stderr, "%s\n", building.error().to_string().c_str());
      return 2;
    }
    name = name.substr(name.find_last_of('/') + 1);
    const Router router(*building);
    proof::draw_walls(name, router, out.traces);
    for (int seed = first; seed < last; ++seed) {
      proof::walk(name, router, source, static_cast<std::uint64_t>(seed), out);
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "guidance_proof: %s\n", problem.what());
    return 1;
  }
}
