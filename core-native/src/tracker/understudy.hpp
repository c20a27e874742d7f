#pragma once

#include <cstdint>

#include "echoway/random.hpp"
#include "tracker/fit_monitor.hpp"
#include "tracker/history.hpp"
#include "tracker/population.hpp"

namespace echoway::tracker {

/// A second belief about the same wearer, with particles drawn by themselves: an island of them (Verge, Dubarry, Del
/// Moral and Moulines 2015). Without a gyroscope a belief may miss a turn by the luck of the draw and lose the wearer;
/// another one seldom misses the same. Which of the two the echoes speak for is told by cumulative sums (Page 1954).
class Understudy {
 public:
  explicit Understudy(std::size_t capacity) : population_(capacity) {}

  [[nodiscard]] Population& population() noexcept { return population_; }
  [[nodiscard]] bool present() const noexcept { return !population_.empty(); }
  void dismiss() noexcept { population_.clear(); }

  /// Begins anew where `belief` is, which fits so well; firing `next` is the first that it follows by itself.
  void learn(const Population& belief, const FitMonitor& fit, std::uint64_t next, Random& random) noexcept;
  /// Changes places with `belief`, each with how well the echoes fit it and what it has made of those of `history`
  /// since they parted: the past that a search has then to beat.
  void change_places(Population& belief, FitMonitor& fit, History& history, Random& random) noexcept;
  /// How well the echoes fit it.
  [[nodiscard]] FitMonitor& fit() noexcept { return fit_; }

  enum class Verdict : std::uint8_t {
    alike,
    ahead,    ///< Of late it has explained the echoes so much better that it is to be believed,
    behind,   ///< or so much worse that it is to begin anew.
  };
  /// Log densities that the belief and this one gave a firing. A verdict begins a new count: the two may change places.
  [[nodiscard]] Verdict judge(double log_belief, double log_own) noexcept;

 private:
  Population population_;
  FitMonitor fit_;
  std::uint64_t since_ = 0;   ///< First firing that it has followed by itself.
  double gained_ = 0.0;       ///< Log odds since it was last behind,
  double lost_ = 0.0;         ///< and since it was last ahead.
};

}  // namespace echoway::tracker
