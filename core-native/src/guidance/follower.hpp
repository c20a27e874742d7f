#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "echoway/guidance/cue.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/aim.hpp"
#include "guidance/announcer.hpp"
#include "guidance/arrival.hpp"
#include "guidance/headway.hpp"
#include "guidance/heard_space.hpp"
#include "guidance/herald.hpp"
#include "guidance/level_change.hpp"
#include "guidance/reaction.hpp"
#include "guidance/standing.hpp"
#include "guidance/steering.hpp"
#include "guidance/view.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// Leads a wearer whose position is known along a way that is laid out anew from wherever they are.
class Follower {
 public:
  /// REQUIRES: all outlive this.
  Follower(const Router& router, const GuideConfig& config, const HeardSpace& heard);
  // Its parts know one another.
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  void lead_to(RouteTree tree);
  void lead_back(std::vector<Spot> crumbs);
  void stop();
  /// The wearer is not where they were thought to be: the way to a destination is laid out afresh, one back ends.
  void start_over();
  [[nodiscard]] bool active() const noexcept { return way_.active(); }
  [[nodiscard]] const Route& route() const noexcept { return way_.route(); }
  [[nodiscard]] Status check_way(RoomIndex room, std::optional<Vec2> at) const { return way_.check(room, at); }

  /// How far the wearer's place may be trusted.
  struct Trust {
    bool vague = false;     ///< Only coarse instructions.
    bool unproven = false;  ///< They are in the room where the tracker found them by itself.
  };
  /// Offers at most one line to `voice`. `turning`: the wearer turns just now and is not told where to go before they
  /// stand still.
  void update(const Estimate& estimate, const Trust& trust, bool turning, Announcer& voice);

  /// Something that no plan knows stands at `at` in the wearer's room: the way is laid round it.
  void note_obstacle(const Estimate& estimate, Vec2 at) noexcept {
    way_.hindrances().hear(estimate.room, at, estimate.time_s);
  }

  /// "Something ahead" has just been told: a walker feels for it and goes on without another word.
  void note_feeling(const Cue& obstacle, const Estimate& estimate) noexcept;

  /// The wearer wants to hear again which way to go: what they were told need not be done first.
  void tell_again() noexcept;

  /// What to do next from here, as the tail of `line`, which is told now, because the wearer has `asked` or by itself.
  [[nodiscard]] CueTail next_step(const Estimate& estimate, const Cue& line, const Announcer& voice, bool asked);

  /// Where the way leads from here, from the chest; none where there is none.
  [[nodiscard]] std::optional<double> direction_from(const Estimate& estimate);

  /// Whether the wearer has been sent over stairs or into an elevator and is not yet known to have come out.
  [[nodiscard]] bool is_between_levels() const noexcept { return levels_.is_under_way(); }
  /// They ask what to do.
  [[nodiscard]] LevelChange::Asked ask_between_levels(const Estimate& estimate);
  /// Echoes need not fit until then: stairs or an elevator were taken.
  [[nodiscard]] double suspended_until() const noexcept { return levels_.suspended_until(); }
  [[nodiscard]] std::optional<LevelTransition> take_transition() noexcept { return levels_.take_transition(); }
  /// True once each time the place is worth a doubt: the wearer gets nowhere though the plan has a way, meets a wall
  /// instead of the door, or is about to be told that they are there in the room where the tracker found them.
  [[nodiscard]] bool take_doubt() noexcept { return std::exchange(doubt_, false); }

 private:
  void forget_told();
  [[nodiscard]] bool find_way(const Estimate& estimate);
  [[nodiscard]] View look(const Estimate& estimate, const Trust& trust);
  void note_standing(View& view) noexcept;
  void note_headway(const View& view) noexcept;
  [[nodiscard]] bool is_on_stairs(const Estimate& estimate, Announcer& voice) noexcept;
  void tell_no_way(double now, Announcer& voice);
  [[nodiscard]] bool lingers(const View& view);
  void lead_on(const View& view, bool turning, Announcer& voice);

  const GuideConfig* config_;
  Way way_;
  Reaction reaction_;
  Aim aim_;
  Steering steering_;
  Arrival arrival_;
  LevelChange levels_;
  Herald herald_;
  Standing standing_;
  Headway headway_;
  bool doubt_ = false;           ///< Raised by what speaks against the place until it is taken: one search answers all.
  double next_look_ = -1e300;
  double still_since_ = -1e300;
  bool was_walking_ = false;
  bool seen_ = false;            ///< Any update has been made.
  double last_pace_ = 0.0;       ///< When they walked last, m/s.
  double feels_until_ = -1e300;  ///< What stands in the way.
};

}  // namespace echoway::guidance
