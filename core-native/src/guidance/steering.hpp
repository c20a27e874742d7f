#pragma once

#include "guidance/announcer.hpp"
#include "guidance/aim.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/met_frame.hpp"
#include "guidance/outlook.hpp"
#include "guidance/side_step.hpp"
#include "guidance/stretch.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// Tells a wearer to stop, to turn, to bear or to go on: whichever takes them along the way, when it is time and where
/// it can be done.
class Steering {
 public:
  /// REQUIRES: all outlive this.
  Steering(const Router& router, const GuideConfig& config, Way& way, Aim& aim, Reaction& reaction,
           const HeardSpace& heard)
      : router_(&router), config_(&config), way_(&way), aim_(&aim), reaction_(&reaction), heard_(&heard),
        frame_(router, config, heard), outlook_(router, config, way.hindrances(), reaction),
        stretch_(router.building()) {}

  void forget() noexcept;
  /// Things that the wearer has met on the stretch that they were told. True while it looks as if they have just met
  /// one: where to go then is soon told better.
  [[nodiscard]] bool watch_stretch(const View& view) noexcept;

  /// Where the wearer is by what they have met. `estimate` is by the tracker alone.
  void watch_place(const Estimate& estimate, bool walking) noexcept { frame_.watch(estimate, walking); }
  [[nodiscard]] Estimate place(const Estimate& estimate) const noexcept { return frame_.place(estimate); }

  /// Whether the wearer has met the frame of the way's next door, at this very moment.
  [[nodiscard]] bool has_met_frame(double now) const noexcept { return frame_.last_met() >= now; }

  // Each offers at most one line; true when that is all there is to say now.
  /// Where the door is, to who has just met its frame or hears a wall where the plan has it.
  [[nodiscard]] bool point_to_door(const View& view, Announcer& voice);
  /// "Stop", to who walks where they are to be.
  void stop(const View& view, Announcer& voice) { (void)say_stop(view, make_cue(CueKind::stop), voice); }
  /// "Stop" before a wall in the walking direction, nearer than the wearer can be turned in.
  [[nodiscard]] bool halt(const View& view, Announcer& voice);
  /// A turn, or a bend while walking.
  [[nodiscard]] bool turn(const View& view, Announcer& voice);
  /// "Go straight", once a leg; again to a wearer who stands on a clear way for long.
  [[nodiscard]] bool go_on(const View& view, Announcer& voice);

  /// Where to turn from here, as the tail of `line`, which is told now, because the wearer has `asked` or by itself;
  /// not present when it goes straight on, and to who walks: they are told where they can turn in time.
  [[nodiscard]] CueTail as_tail(const View& view, const Cue& line, const Announcer& voice, bool asked);

  /// The last instruction is still being carried out.
  [[nodiscard]] bool is_holding(double now) const noexcept { return now < pacing_.hold_until; }
  /// The next leg begins: "go straight" is due.
  void begin_leg() noexcept { pacing_.straight_due = true; }
  /// Whatever was told before.
  void tell_again() noexcept;
  [[nodiscard]] double last_said() const noexcept { return pacing_.last_said; }
  void note_said(double now) noexcept { pacing_.last_said = now; }

 private:
  /// When the next instruction is due.
  struct Pacing {
    bool straight_due = true;    ///< "Go straight" has not been said on this leg.
    double hold_until = -1e300;  ///< The last instruction is still being carried out.
    double last_said = -1e300;
    bool door_due = false;         ///< The wearer has met the frame of a doorway and shall know where it is.
    double looked_round = -1e300;  ///< The wearer was asked to turn slowly.
  };
  [[nodiscard]] bool say_turn(const View& view, Announcer& voice);
  [[nodiscard]] bool is_kept_from_turning(const View& view, const Cue& cue, double direction, Announcer& voice);
  [[nodiscard]] static bool is_settling(const View& view) noexcept;
  [[nodiscard]] bool is_stuck(const View& view, double seconds) const noexcept;
  [[nodiscard]] bool hears_wall(const View& view, double direction);
  [[nodiscard]] bool hears_free(const View& view, double direction, const Cue& cue) const;
  void note_frame() noexcept;
  [[nodiscard]] bool face_way(const View& view, Announcer& voice);
  [[nodiscard]] bool look_round(const View& view, Announcer& voice);
  [[nodiscard]] bool leave_tight_spot(const View& view, Announcer& voice);
  void word_turn(const View& view, double direction, const Announcer& voice, Cue& cue) const;
  [[nodiscard]] bool say_bend(const View& view, Announcer& voice);
  [[nodiscard]] bool put_safe_turn_in_tail(const View& view, Cue& cue) const;
  [[nodiscard]] bool say_stop(const View& view, const Cue& cue, Announcer& voice);
  [[nodiscard]] bool stop_walker(const View& view, Announcer& voice);
  [[nodiscard]] bool say_step(const View& view, const SideStep& step, Announcer& voice);
  [[nodiscard]] bool turn_in_tight_spot(const View& view, const Demand& demand, Announcer& voice);
  [[nodiscard]] Cue straight_cue(const View& view, double along, bool amend) const;
  [[nodiscard]] double length_to_tell(const View& view) const;
  void hold_after(const Cue& cue, const View& view);

  const Router* router_;
  const GuideConfig* config_;
  Way* way_;
  Aim* aim_;
  Reaction* reaction_;
  const HeardSpace* heard_;
  MetFrame frame_;
  Outlook outlook_;
  Stretch stretch_;
  Pacing pacing_;
};

}  // namespace echoway::guidance
