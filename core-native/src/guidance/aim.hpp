#pragma once

#include <optional>

#include "guidance/doorway.hpp"
#include "guidance/reaction.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// Where to head for on the way: the next turn, the spot before the next door or one beyond it. Small errors of
/// position do not send a wearer from one to the other and back.
class Aim {
 public:
  /// REQUIRES: all outlive this.
  Aim(const Router& router, const GuideConfig& config, const Way& way, const Reaction& reaction)
      : router_(&router), config_(&config), way_(&way), reaction_(&reaction) {}

  /// Works out where the wearer of `view` has to go; takes its pose, speed and turn, fills in the rest.
  void take(View& view);
  /// The wearer has been sent to the target, which is kept until they are there if it is near.
  void keep(const View& view) noexcept;
  void forget() noexcept { kept_.room = kNoRoom; }

  /// True when the wearer can go straight to `at`, which lies before the first door of the line or just beyond it.
  [[nodiscard]] bool in_reach(const Estimate& estimate, Vec2 at) const;

 private:
  [[nodiscard]] std::optional<Doorway> doorway(RoomIndex room) const noexcept;
  struct Choice {
    Vec2 at{};
    bool beyond = false;   ///< The turn or the door at hand is to be passed,
    bool through = false;  ///< and can be straight away.
  };
  [[nodiscard]] Choice far_point(const View& view, double door_along) const;
  [[nodiscard]] Vec2 settle(const Estimate& estimate, const Choice& choice);
  [[nodiscard]] bool still_keeps(const Estimate& estimate) const;

  const Router* router_;
  const GuideConfig* config_;
  const Way* way_;
  const Reaction* reaction_;
  bool slanting_ = false;  ///< Aslant through a doorway from close before its side.
  bool through_ = false;   ///< The wearer heads through a doorway, not for the spot before it.
  Spot kept_{};            ///< No room: none.
  double kept_since_ = -1e300;
};

}  // namespace echoway::guidance
