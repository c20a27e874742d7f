#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "echoway/locate/estimate.hpp"
#include "echoway/session.hpp"
#include "echoway/sim/simulate.hpp"

/// A fixed set of walks whose tracks must come out the same, bit for bit, from every compiler, build type, number of
/// threads and 64-bit processor.
namespace echoway::tracks {

struct Track {
  std::string name;                  ///< Walk and method, without blanks.
  std::vector<Firing> scans;         ///< What the simulated belt heard.
  std::vector<Estimate> estimates;   ///< After every firing that renewed one.
};

/// Feeds what a simulated walk left behind to a session, in order of time. Empty when the session does not open.
[[nodiscard]] std::vector<Estimate> follow(const Building& building, const SessionConfig& config,
                                           const sim::Simulation& walk);

/// The whole set, `threads` at a time, always in the same order.
[[nodiscard]] std::vector<Track> run(int threads);

/// FNV-1a over the bits of every number.
[[nodiscard]] std::uint64_t hash_scans(const Track& track);
[[nodiscard]] std::uint64_t hash_estimates(const Track& track);

/// One line a track: name, hash of its scans, hash of its estimates, number of estimates.
[[nodiscard]] std::string hashes(const std::vector<Track>& all);

/// One line an estimate, for comparing machines that do not agree to the bit: name, time, room, x, y, heading.
[[nodiscard]] std::string rows(const std::vector<Track>& all);

}  // namespace echoway::tracks
