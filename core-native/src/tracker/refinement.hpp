#pragma once

#include "tracker/modes.hpp"
#include "tracker/population.hpp"
#include "tracker/search_tools.hpp"

namespace echoway::tracker {

/// Share of a replayed firing's evidence that counts: three quarters of the first pass of sensors, half of what they
/// say again later. What stands in no plan is heard again and again, and whichever of thousands of places it fits
/// would drive out the right one.
[[nodiscard]] double share_of(std::uint64_t firing, std::uint64_t first, const BeltConfig& belt) noexcept;

/// Brings particles up to the present through past firings, as the tracker itself would have: a particle filter
/// that runs behind and catches up, cut into slices. Once every sensor was heard twice and few places are left,
/// they are modes, and the evidence between them counts as little as it does in the tracker: what stands in no
/// plan would drop the right one.
///
/// Particles are drawn by a look ahead (Lin, Chen and Liu 2013): the sweep knew the first firings. What it made of them
/// is taken back firing by firing as they are replayed, not at once: the particles of the best places would begin with
/// the least weight, and most be gone before the firings come that speak for them.
class Refinement {
 public:
  explicit Refinement(std::size_t capacity) : population_(capacity), modes_(capacity, Modes::Parameters{}) {}

  /// Empties it; particles pushed now stand just before firing number `first` of the history. Who drew them knew so
  /// many firings from there on as `foreseen` says. `modes`: whether the few places that are left become modes.
  void begin(std::uint64_t first, std::uint64_t foreseen, bool modes) noexcept;
  [[nodiscard]] Population& population() noexcept { return population_; }

  /// Replays about `budget` firings of single particles, or fewer where cells must first be compiled: of that, so many
  /// as `compiled_per_replay` (Scene::compile_work) cost as much as one. True when all particles have heard everything.
  bool work(const SearchTools& tools, Random& random, std::size_t budget, std::size_t compiled_per_replay) noexcept;

  /// What the last slice cost, in firings of single particles.
  [[nodiscard]] std::size_t spent() const noexcept { return spent_; }

  /// Log of what the weights pushed added up to, times the mean likelihood of the firings since.
  [[nodiscard]] double log_evidence() const noexcept { return log_evidence_; }

 private:
  void close_round(const SearchTools& tools, Random& random) noexcept;
  void resample(const SearchTools& tools, Random& random) noexcept;

  Population population_;
  Modes modes_;
  bool in_modes_ = false;
  std::uint64_t first_ = 0;            ///< Its interval, from the firing before, is not walked.
  std::uint64_t foreseen_end_ = 0;     ///< Firings before this one were known to who drew the particles.
  std::uint64_t reached_ = 0;          ///< All particles have heard the firings before this one,
  std::uint64_t round_end_ = 0;        ///< and those before the cursor the ones before this.
  std::size_t cursor_ = 0;
  std::size_t spent_ = 0;
  double log_evidence_ = 0.0;
};

}  // namespace echoway::tracker
