#pragma once

#include <optional>
#include <span>

#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/announcer.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/turn_watch.hpp"

namespace echoway::guidance {

/// Asks a lost wearer for what will show where they are: to stop and turn, then to walk a little, always forward, to
/// where the belt hears that it is free, and to turn again now and then.
class Search {
 public:
  /// REQUIRES: all outlive this.
  Search(const Router& router, const GuideConfig& config, const HeardSpace& heard, const TurnWatch& turning)
      : router_(&router), config_(&config), heard_(&heard), turning_(&turning) {}

  /// Nothing is known and nothing has been said.
  void begin() noexcept;

  /// The wearer is lost, `estimate` the best guess. `starting`: nothing has been known yet, so that the tracker is
  /// given a moment, unless they have `asked` where they are. `wanted`: where the way leads from the best guess, from
  /// the chest; looked at when a request is_due(). Offers at most one line; true when it says that the place is not
  /// known.
  bool update(const Estimate& estimate, std::span<const Hypothesis> places, std::optional<double> wanted, bool starting,
              bool asked, Announcer& voice);

  /// Whether the next request may be made.
  [[nodiscard]] bool is_due(double now) const noexcept { return told_ && now >= next_request_; }

  /// Whether the wearer has been sent on and may still be about to set off: what is told now is done where they get to.
  [[nodiscard]] bool sets_off(double now) const noexcept { return now < off_by_; }

  /// Whether the wearer was lost up to now, and whether they have been told so.
  [[nodiscard]] bool is_on() const noexcept { return on_; }
  [[nodiscard]] bool was_told() const noexcept { return told_; }
  void end() noexcept { on_ = told_ = false; }

 private:
  [[nodiscard]] bool tell_uncertain(double now, bool asked, Announcer& voice);
  [[nodiscard]] bool stop_before_echo(const Estimate& estimate, Announcer& voice) const;
  [[nodiscard]] Cue next_request(double now, std::span<const Hypothesis> places, std::optional<double> wanted) const;
  [[nodiscard]] std::optional<double> freest(double preferred, double now, std::span<const Hypothesis> places) const;
  [[nodiscard]] double share_free(double direction, std::span<const Hypothesis> places) const noexcept;
  [[nodiscard]] Cue move_to(double direction, double now, std::span<const Hypothesis> places) const;
  [[nodiscard]] double length_of_move(double direction, double now, std::span<const Hypothesis> places) const;
  [[nodiscard]] bool is_near_stairs(const Hypothesis& place) const;
  void note_request(const Cue& cue, double now) noexcept;

  const Router* router_;
  const GuideConfig* config_;
  const HeardSpace* heard_;
  const TurnWatch* turning_;
  bool on_ = true;
  bool told_ = false;
  double since_ = -1.0;
  double next_request_ = -1e300; ///< Not before.
  double off_by_ = -1e300;       ///< Who was sent on is seen to walk by then.
  int moves_ = 0;                ///< Since the last request to turn slowly.
  double step_direction_ = 0.0;  ///< Of the last step that was asked for, from where the chest faced at first.
};

}  // namespace echoway::guidance
