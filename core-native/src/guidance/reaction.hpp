#pragma once

#include "echoway/guidance/cue.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"

namespace echoway::guidance {

/// This wearer's own way of reacting to a line, learnt from the turns that they make.
class Reaction {
 public:
  explicit Reaction(const GuideConfig& config) : config_(&config), seconds_(config.reaction_s) {}

  /// From the end of a line to the wearer acting on it.
  [[nodiscard]] double seconds() const noexcept { return seconds_; }
  /// What walkers who were told the same may be apart in time, seconds; less once this one is known.
  [[nodiscard]] double spread_s() const noexcept;
  /// How far a wearer at `speed` goes while `cue` is spoken and until they act on it, metres.
  [[nodiscard]] double way(const Cue& cue, double speed) const noexcept;

  /// `cue` has been told to somebody who faces `heading`: when it is a turn, see how long they take to make it.
  void time(const Cue& cue, double heading, double now) noexcept;
  void watch(const Estimate& estimate) noexcept;
  /// A heading that jumps is no turn to learn from.
  void stop_watching() noexcept { told_until_ = -1.0; }

 private:
  const GuideConfig* config_;
  double seconds_;
  int learnt_ = 0;            ///< From so many turns.
  double told_until_ = -1.0;  ///< A turn was told and has not been seen yet; when its line ends.
  double told_from_ = 0.0;    ///< Heading then.
  bool told_left_ = false;
};

}  // namespace echoway::guidance
