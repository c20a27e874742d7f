#pragma once

#include "echoway/locate/estimate.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// What is nearer along the way than this is at hand already, metres.
inline constexpr double kAtHand = 0.8;

/// What the wearer's pose means for the way, worked out once an update.
struct View {
  const Estimate* estimate = nullptr;
  double now = 0.0;
  bool vague = false;         ///< Only coarse instructions.
  bool unproven = false;      ///< They are where the tracker found them by itself: another room may look the same.
  bool walking = false;
  double speed = 0.0;
  double pace = 0.0;          ///< Metres a second at which they may walk on by themselves, feeling for a thing.
  double still_since = 0.0;   ///< The wearer stands since then.
  double remaining = 0.0;     ///< Metres to the goal.
  Manoeuvre turn{};
  bool at_turn = false;       ///< A cue spoken now is acted upon where the turn is.
  Vec2 target{};              ///< Where to head for now.
  double target_away = 0.0;
  double off = 0.0;           ///< Direction to go, from the chest.
  double room_to_miss = 0.0;  ///< How far beside the target will do, metres.
};

}  // namespace echoway::guidance
