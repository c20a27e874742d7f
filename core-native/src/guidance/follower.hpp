#pragma once

#include <optional>
#include <vector>

#include "echoway/guidance/cue.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/announcer.hpp"
#include "guidance/hindrances.hpp"
#include "guidance/route_line.hpp"

namespace echoway::guidance {

/// What an instruction must leave free.
struct Demand {
  double free_m = 0.65;  ///< Ahead, once it has been carried out.
  double sigmas = 1.5;   ///< How far the position may be off, in its standard deviations.
};

/// Leads a wearer whose position is known along a way that is laid out anew from wherever they are.
class Follower {
 public:
  Follower(const Router& router, const GuideConfig& config)
      : router_(&router), config_(&config), hindrances_(config), reaction_s_(config.reaction_s) {}

  void lead_to(RouteTree tree);
  void lead_back(std::vector<Spot> crumbs);
  void stop();
  /// The wearer is not where they were thought to be: the way to a destination is laid out afresh, one back ends.
  void start_over();
  [[nodiscard]] bool active() const noexcept { return mode_ != Mode::none; }
  [[nodiscard]] const Route& route() const noexcept { return route_; }

  /// Offers at most one line to `voice`. `vague`: only coarse instructions. `turning`: the wearer turns just now and is not
  /// told where to go before they stand still.
  void update(const Estimate& estimate, bool vague, bool turning, Announcer& voice);

  /// Something that no plan knows stands at `at` in the wearer's room: the way is laid round it.
  void note_obstacle(const Estimate& estimate, Vec2 at) noexcept { hindrances_.hear(estimate.room, at, estimate.time_s); }

  /// What to do next from here, as the tail of another line.
  [[nodiscard]] CueTail next_step(const Estimate& estimate);

  /// Echoes need not fit until then: stairs or an elevator were taken.
  [[nodiscard]] double suspended_until() const noexcept { return suspended_until_; }
  [[nodiscard]] std::optional<LevelTransition> take_transition() noexcept;

 private:
  enum class Mode : std::uint8_t { none, tree, crumbs };

  /// What the wearer's pose means for the way, worked out once an update.
  struct View {
    const Estimate* estimate = nullptr;
    double now = 0.0;
    bool vague = false;
    bool walking = false;
    double speed = 0.0;
    double remaining = 0.0;     ///< Metres to the goal.
    Manoeuvre turn{};
    bool at_turn = false;       ///< A cue spoken now is acted upon where the turn is.
    Vec2 target{};              ///< Where to head for now.
    double target_away = 0.0;
    double off = 0.0;           ///< Direction to go, from the chest.
    double room_to_miss = 0.0;  ///< How far beside the target will do, metres.
  };

  void learn_reaction(const Estimate& estimate) noexcept;
  void time_reaction(const View& view, const Cue& cue) noexcept;
  /// How far a walker goes while `cue` is spoken and until they act on it.
  [[nodiscard]] double lead(const View& view, const Cue& cue) const noexcept;
  /// Where a wearer who goes straight on does what they are told, in metres from here.
  struct Approach {
    Vec2 ahead{};             ///< Unit.
    double blur = 0.0;        ///< The position may be off by so much.
    double due = 0.0;         ///< Most likely,
    double latest = 0.0;      ///< and at the latest,
    double until_wall = 0.0;  ///< but no farther than this.
  };
  [[nodiscard]] Approach approach(const View& view, const Cue& cue, const Demand& demand) const noexcept;
  [[nodiscard]] bool clear_of_walls(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept;
  [[nodiscard]] bool clear_of_things(const View& view, const Approach& way, double direction, const Demand& demand) const noexcept;
  [[nodiscard]] bool clear_ahead(const View& view, const Cue& cue, double direction, const Demand& demand) const noexcept;
  [[nodiscard]] bool grazes(const View& view) const noexcept;
  void note_touch(const View& view) noexcept;
  [[nodiscard]] BoundFor bound_for(const Estimate& estimate) const;
  [[nodiscard]] bool find_way(const Estimate& estimate);
  [[nodiscard]] View look(const Estimate& estimate, bool vague);
  [[nodiscard]] bool in_reach(const Estimate& estimate, Vec2 at) const;
  void aim(View& view);
  [[nodiscard]] std::optional<Vec2> slant_through_door(const Estimate& estimate, bool begun) const;
  void note_progress(const View& view);
  [[nodiscard]] bool on_stairs(const Estimate& estimate) noexcept;
  [[nodiscard]] bool arrive(const View& view, Announcer& voice);
  [[nodiscard]] bool linger(const View& view);
  [[nodiscard]] bool take_link(const View& view, Announcer& voice);
  [[nodiscard]] bool halt(const View& view, Announcer& voice);
  [[nodiscard]] bool steer(const View& view, Announcer& voice);
  [[nodiscard]] bool go_on(const View& view, Announcer& voice);
  [[nodiscard]] bool tell_ahead(const View& view, Announcer& voice);
  [[nodiscard]] bool tell_link(const View& view, std::int32_t link, double along, Vec2 at, Announcer& voice);
  [[nodiscard]] bool say_turn(const View& view, Announcer& voice);
  [[nodiscard]] bool stop_walker(const View& view, Announcer& voice);
  [[nodiscard]] bool turn_in_tight_spot(const View& view, const Demand& demand, Announcer& voice);
  void hold_after(const Cue& cue, const View& view);
  [[nodiscard]] bool still_bound_for(const Estimate& estimate) const;
  [[nodiscard]] Cue goal_cue(CueKind kind) const;

  const Router* router_;
  const GuideConfig* config_;
  Mode mode_ = Mode::none;
  RouteTree tree_;
  std::vector<Spot> crumbs_;
  Route route_;
  std::vector<LinePoint> line_;
  Hindrances hindrances_;
  std::vector<std::int32_t> doors_;      ///< Of the way that was told, in order.
  std::vector<std::int32_t> new_doors_;
  bool new_way_ = false;                 ///< It leads through other doors than the wearer was told.
  bool slanting_ = false;                ///< The same, aslant from close before the doorway's side.
  bool through_ = false;                 ///< The wearer heads through a doorway, not for the spot before it.
  bool straight_due_ = true;             ///< "Go straight" has not been said on this leg.
  double least_cost_ = 1e300;            ///< Nearest to the goal so far.
  double next_look_ = -1e300;
  double hold_until_ = -1e300;           ///< The last instruction is still being carried out.
  double last_said_ = -1e300;
  // This wearer's own way of reacting to a line, learnt from the turns they make.
  double reaction_s_;
  int reactions_ = 0;                    ///< Learnt from so many.
  double turn_told_until_ = -1.0;        ///< A turn was told and has not been seen yet; when its line ends.
  double turn_told_from_ = 0.0;          ///< Heading then.
  bool turn_told_left_ = false;
  // The spot that a wearer was last sent to, when it is near: kept until they are there, so that small errors of their
  // position do not send them to and fro.
  Spot bound_for_{};
  double bound_since_ = -1e300;
  // A stretch that was told and begun: who stops well short of its end has met something.
  double stretch_m_ = -1.0;              ///< Negative: none.
  Spot stretch_from_{};
  bool stretch_begun_ = false;
  int stood_ = 0;                        ///< Times in a row that the wearer did not set off.
  double still_since_ = -1e300;
  bool was_walking_ = false;
  std::int32_t told_door_ = -1;
  std::int32_t told_link_ = -1;
  bool told_narrow_ = false;
  RoomIndex in_room_ = kNoRoom;          ///< The wearer is in this room
  double in_room_since_ = -1e300;        ///< since then.
  double arrived_at_ = -1.0;             ///< When "arrived" was said; negative before.
  double suspended_until_ = -1e300;
  RoomIndex landing_ = kNoRoom;
  std::optional<LevelTransition> transition_;
};

}  // namespace echoway::guidance
