#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tracker/placed.hpp"
#include "tracker/population.hpp"
#include "tracker/summary.hpp"

namespace echoway::tracker {

/// The places that a belief has fallen apart into, such as the two ends of a symmetric hall: a mixture of particle
/// filters (Vermaak, Doucet and Perez 2003). Plain resampling lets all but one of them die out by chance within
/// seconds; here each keeps particles enough to be followed for as long as it is possible at all.
class Modes {
 public:
  struct Parameters {
    double radius = 1.5;                 ///< Metres from a summary's place within which a particle belongs to it,
    double angle = degrees(75.0);        ///< and from its heading.
    double least = 4.5e-5;               ///< Probability of a place from which on it keeps
    std::size_t fewest = 30;             ///< at least so many particles,
    std::size_t fewest_blind = 80;       ///< more without a gyroscope, when they must guess every turn.
  };

  /// For populations of at most `capacity` particles.
  Modes(std::size_t capacity, const Parameters& parameters) : parameters_(parameters), of_(capacity) {}

  /// Resamples `population` to `target` particles and as many more as unlikely places need. No allocation.
  /// REQUIRES: normalized. `summary` is of it, now or a firing ago; of another belief, all particles lie elsewhere.
  void resample(Population& population, const Summary& summary, const Building& building, std::size_t target,
                bool blind, Random& random) noexcept;

 private:
  /// Places of a summary, and last whatever lies elsewhere.
  static constexpr std::size_t kMost = Summary::kMaxClusters + 1;
  static_assert(kMost <= Population::kMostModes);

  [[nodiscard]] std::size_t nearest(const Placed& at, std::size_t count) const noexcept;

  Parameters parameters_;
  std::array<Placed, Summary::kMaxClusters> places_{};   ///< Of the summary, in their levels' frames.
  std::vector<std::uint8_t> of_;         ///< Per particle: its place.
};

}  // namespace echoway::tracker
