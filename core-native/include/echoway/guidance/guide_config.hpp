#pragma once

#include "echoway/belt/belt.hpp"
#include "echoway/building/building.hpp"
#include "echoway/units.hpp"

namespace echoway {

/// How a guide speaks and when. Times are seconds, lengths metres.
struct GuideConfig {
  BeltConfig belt{};

  // The voice.
  double seconds_per_word = 0.34;     ///< 175 words a minute, an ordinary speech engine.
  double line_overhead_s = 0.25;      ///< Before the first and after the last word.
  double reaction_s = 0.8;            ///< From the end of a line to the wearer acting on it.
  double repeat_gap_s = 10.0;         ///< Nothing is said twice within this, unless asked.
  double contradiction_gap_s = 5.0;   ///< No line takes back another within this.

  // Certainty. Entered and left at different values, so that it does not flutter.
  double lost_sigma_m = 1.5;          ///< Above: the position is not known.
  double found_sigma_m = 0.8;         ///< Below: it is again.
  double lost_probability = 0.5;      ///< Of the room; below: not known.
  double found_probability = 0.7;
  double lost_after_s = 1.5;          ///< How long it must stay so before the wearer is told.
  double found_after_s = 0.9;
  double steady_lost_after_s = 30.0;  ///< The same where only the echoes do not fit and the place goes on steadily.
  double relapse_s = 40.0;            ///< Lost again so soon after it was found: the next find must last twice as long.
  double settle_s = 2.0;              ///< A place that has jumped must hold so long before the way is told from there.
  double vague_sigma_m = 0.6;         ///< Above: only coarse instructions.
  double vague_probability = 0.8;
  double probe_gap_s = 9.0;           ///< After a request to turn, while lost, until the next request;
  double step_gap_s = 6.0;            ///< after one to step.

  // The way.
  double renew_s = 0.2;               ///< The way is looked at this often.
  double ahead_rad = degrees(20.0);   ///< A direction within this is "ahead".
  double fuse_m = 0.9;                ///< Turns this close together are one.
  double arrive_m = 0.8;              ///< This near is there.
  double door_cue_m = 3.0;            ///< Doors on the way are told from this far.
  double other_way_m = 1.0;           ///< Another door is taken only where it saves more than this.
  double wrong_way_m = 1.5;           ///< Walked away from the goal by this much.
  double body_m = 0.25;               ///< Half the wearer's breadth.
  double default_speed_mps = 0.8;     ///< Of a walking wearer, while none is known.
  double nudge_s = 11.0;              ///< A wearer who stands still on a way is told again after this.
  double stairs_patience_s = 45.0;    ///< Echoes need not fit for this long once stairs are taken.
  double elevator_patience_s = 120.0;
  double unasked_share = 0.6;         ///< Of that for wearers at stairs or an elevator to which they were not sent.

  // Obstacles.
  double obstacle_m = 1.2;            ///< Tell of them from this far when standing; further when walking.
  int obstacle_firings = 3;           ///< So many must agree.

  /// How long whoever takes stairs or an elevator may need to come out, seconds.
  [[nodiscard]] double patience_s(LevelLinkKind kind) const noexcept {
    return kind == LevelLinkKind::stairs ? stairs_patience_s : elevator_patience_s;
  }
};

}  // namespace echoway
