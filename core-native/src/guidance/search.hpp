#pragma once

#include <span>

#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/announcer.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/turn_watch.hpp"

namespace echoway::guidance {

/// Asks a lost wearer for what will show where they are: to stop and turn, then to turn or step again, each time the action
/// that tells the likely places best apart.
class Search {
 public:
  /// REQUIRES: all outlive this.
  Search(const Router& router, const GuideConfig& config, const HeardSpace& heard, const TurnWatch& turning)
      : router_(&router), config_(&config), heard_(&heard), turning_(&turning) {}

  /// Nothing is known and nothing has been said.
  void begin() noexcept;

  /// The wearer is lost, `estimate` the best guess. `starting`: nothing has been known yet, so that the tracker is given a
  /// moment, unless they have `asked` where they are. Offers at most one line; true when it says that the place is not known.
  bool update(const Estimate& estimate, std::span<const Hypothesis> places, bool starting, bool asked, Announcer& voice);

  /// Whether the wearer was lost up to now, and whether they have been told so.
  [[nodiscard]] bool is_on() const noexcept { return on_; }
  [[nodiscard]] bool was_told() const noexcept { return told_; }
  void end() noexcept { on_ = told_ = false; }

 private:
  [[nodiscard]] bool tell_uncertain(double now, bool asked, Announcer& voice);
  [[nodiscard]] bool stop_before_echo(const Estimate& estimate, Announcer& voice) const;
  [[nodiscard]] Cue next_request(double now, std::span<const Hypothesis> places) const;

  const Router* router_;
  const GuideConfig* config_;
  const HeardSpace* heard_;
  const TurnWatch* turning_;
  bool on_ = true;
  bool told_ = false;
  double since_ = -1.0;
  double last_request_ = -1e300;
  bool turned_last_ = false;     ///< The last request was to turn.
  double step_direction_ = 0.0;  ///< Of the last step that was asked for, from where the chest faced at first.
};

}  // namespace echoway::guidance
