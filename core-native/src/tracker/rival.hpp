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
  /// The same for a belief that was given up and may return: no search chose it for how well it fits.
  void begin_return(double log_odds) noexcept;
  void dismiss() noexcept { population_.clear(); }

  /// What its log odds have gained since the probation began.
  [[nodiscard]] double gain() const noexcept { return log_odds_ - log_begin_; }

  enum class Verdict : std::uint8_t { undecided, rejected, accepted };
  /// Of the belief: sure of its place; sure of it once, but it fits no longer; never sure of it since it was found.
  enum class Belief : std::uint8_t { proved, poor, unproved };
  /// What was made of a firing.
  struct Heard {
    double log_belief = 0.0;   ///< Log density that the belief gave it,
    double log_rival = 0.0;    ///< and the rival,
    double fit = 0.0;          ///< and how much better than no place at all the rival fits (FitMonitor::gain()).
  };
  [[nodiscard]] Verdict judge(const Heard& heard, Belief belief) noexcept;

 private:
  /// Log odds below which nothing more is expected of it,
  [[nodiscard]] double least(Belief belief) const noexcept;
  /// and from which on it is believed.
  [[nodiscard]] double needed(Belief belief) const noexcept;
  /// Whether it has had its time.
  [[nodiscard]] bool overdue(Belief belief) const noexcept;
  /// Whether it explains what is heard, not just better than the belief does.
  [[nodiscard]] bool fits() const noexcept;

  Population population_;
  double log_begin_ = 0.0;
  double log_odds_ = 0.0;
  double fit_ = 0.0;             ///< Sum of how much better than no place at all it fits.
  bool found_ = true;            ///< By a search.
  std::uint64_t age_ = 0;
};

}  // namespace echoway::tracker
