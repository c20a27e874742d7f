#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "echoway/belt/belt_health.hpp"
#include "echoway/guidance/cue.hpp"
#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/locate/locator.hpp"
#include "echoway/result.hpp"
#include "echoway/routing/router.hpp"

namespace echoway {

/// Tells a wearer the way, and what they must know, as cues (docs/guidance.md). Works without a destination too: rooms
/// that are entered, doors that are near, things in the way, and where the wearer is when asked.
///
/// Feed it in order of time; fetch cues with next_cue() after every call. Promises, besides the voice's own (rank,
/// repeats, contradictions):
///  1. no instruction is given on a position that is not known;
///  2. a cue is finished, and the wearer has had time to react, before it is needed;
///  3. nothing is said while nothing changes.
/// Never throws. Allocates only when a destination is set and when a way grows longer than any before.
class Guide {
 public:
  /// REQUIRES: `router` outlives the guide.
  explicit Guide(const Router& router, const GuideConfig& config = {});
  Guide(Guide&&) noexcept;
  Guide& operator=(Guide&&) noexcept;
  ~Guide();

  /// As given when it was made.
  [[nodiscard]] const GuideConfig& config() const noexcept;

  // The wearer's wishes. All answer by a cue too.
  /// `here`: the room in which the wearer is or said that they are. A destination that nobody is led to from outside
  /// its room is refused to who is not in there (see Router::check_goal).
  Status set_destination(const Goal& goal, RoutePreferences preferences = {}, RoomIndex here = kNoRoom);
  /// By name: a place, an exit, a room (see Router::find_goal).
  Status set_destination(std::string_view name, RoutePreferences preferences = {}, RoomIndex here = kNoRoom);
  Status way_out(RoutePreferences preferences = {}, RoomIndex here = kNoRoom);
  /// Back the way the wearer came, to where the guide first knew them.
  Status back_track();
  void clear_destination();
  void where_am_i();
  /// Says the last line again that told the wearer to do something; false when there is none that still holds.
  bool repeat();

  // What happens.
  void on_estimate(const Estimate& estimate, std::span<const Hypothesis> hypotheses = {});
  /// Looks for things in the way; the estimate taken is the newest one.
  void on_firing(const Firing& firing);
  void on_belt_health(const BeltHealth& health, double now_s);
  /// The locator starts, or starts over, from `start`: whatever followed from where the wearer was taken to be is
  /// forgotten, the breadcrumbs too. A destination is kept and the way there told anew from the next estimate; a way
  /// back ends. Before the first call, who is found by the first estimate is taken to have said where they stand and
  /// which way they face.
  void on_start(const Start& start);

  /// Takes the next cue to be spoken; false when there is none.
  bool next_cue(Cue& cue);
  /// Set once each time the wearer is sent over stairs or into an elevator, and once they are found where it leads:
  /// pass it to the locator.
  [[nodiscard]] std::optional<LevelTransition> take_level_transition();

  /// True once each time something speaks against a place that the locator found and nobody told, or told without the
  /// way that they face, or it has yet to be proved: the wearer gets nowhere though the plan has a way, meets a wall
  /// where the door should be, or has reached their destination in the room where they were found. Pass it on to the
  /// locator, they may be elsewhere.
  [[nodiscard]] bool take_doubt();

  [[nodiscard]] bool has_destination() const;
  /// Whether a way leads to the destination from a room, and from `at` in it where that is known (see
  /// Router::check_way); success without a destination.
  [[nodiscard]] Status check_way(RoomIndex room, std::optional<Vec2> at) const;
  /// Distance of the nearest thing in the way that no plan knows, metres from the chest; negative without one.
  [[nodiscard]] double obstacle_ahead_m() const;
  /// The way from where the wearer was last; empty without a destination.
  [[nodiscard]] const Route& route() const;
  /// Breadcrumbs, oldest first.
  [[nodiscard]] std::span<const Spot> breadcrumbs() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace echoway
