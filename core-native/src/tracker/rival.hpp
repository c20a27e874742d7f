#pragma once

#include <cstdint>

#include "tracker/population.hpp"

namespace echoway::tracker {

/// Another belief on probation: a sequential probability ratio test (Wald 1945) on firings that the search which found
/// it has not seen. Whoever was chosen among a million places to fit the last firings must prove itself on the next
/// ones; judged by the firings that chose it, it would too often win by chance.
class Rival {
 public:
  explicit Rival(std::size_t capacity) : population_(capacity) {}

  [[nodiscard]] Population& population() noexcept { return population_; }
  [[nodiscard]] bool present() const noexcept { return !population_.empty(); }

  /// `log_odds`: against the belief, before the first firing of the probation.
  void begin(double log_odds) noexcept;
  void dismiss() noexcept { population_.clear(); }

  /// What its log odds have gained since the probation began.
  [[nodiscard]] double gain() const noexcept { return log_odds_ - log_begin_; }

  enum class Verdict : std::uint8_t { undecided, rejected, accepted };
  /// Log densities that the belief and the rival gave a firing, and whether a belief that was sure once fits no longer.
  [[nodiscard]] Verdict judge(double log_belief, double log_rival, bool belief_poor) noexcept;

 private:
  /// Log odds below which nothing more is expected of it.
  [[nodiscard]] double least(bool belief_poor) const noexcept;
  /// Whether it has had its time.
  [[nodiscard]] bool overdue(bool belief_poor) const noexcept;

  Population population_;
  double log_begin_ = 0.0;
  double log_odds_ = 0.0;
  std::uint64_t age_ = 0;
};

}  // namespace echoway::tracker
