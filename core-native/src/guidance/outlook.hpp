#pragma once

#include "echoway/guidance/guide_config.hpp"
#include "echoway/routing/router.hpp"
#include "guidance/hindrances.hpp"
#include "guidance/reaction.hpp"
#include "guidance/view.hpp"

namespace echoway::guidance {

/// What an instruction must leave free.
struct Demand {
  double free_m = 0.55;  ///< Ahead, once it has been carried out.
  double sigmas = 2.0;   ///< How far position and heading may be off, in their standard deviations.
  bool things = true;    ///< Of things that no plan knows too, of which only some points are known.
};

/// Looks along an instruction, from wherever a wearer may come to carry it out.
class Outlook {
 public:
  /// REQUIRES: all outlive this.
  Outlook(const Router& router, const GuideConfig& config, const Hindrances& hindrances, const Reaction& reaction)
      : router_(&router), config_(&config), hindrances_(&hindrances), reaction_(&reaction) {}

  /// Where a wearer who goes straight on does what they are told, in metres from here.
  struct Approach {
    double blur = 0.0;        ///< The position may be off by so much.
    double wobble = 0.0;      ///< and the direction by so much.
    double due = 0.0;         ///< Most likely,
    double latest = 0.0;      ///< and at the latest.
  };
  [[nodiscard]] Approach approach(const View& view, const Cue& cue, const Demand& demand) const noexcept;

  /// True when a wearer who has done as they were told, to `direction` from the chest, faces no wall.
  [[nodiscard]] bool clear_of_walls(const View& view, const Approach& way, double direction,
                                    const Demand& demand) const noexcept;
  /// The same of things that no plan knows.
  [[nodiscard]] bool clear_of_things(const View& view, const Approach& way, double direction,
                                     const Demand& demand) const noexcept;
  /// Of both, for a wearer who is told `cue` now.
  [[nodiscard]] bool clear_ahead(const View& view, const Cue& cue, double direction,
                                 const Demand& demand) const noexcept;

  /// True when a walker who goes on like this brushes a wall before the next point, though the way to it is clear.
  [[nodiscard]] bool grazes(const View& view) const noexcept;

 private:
  const Router* router_;
  const GuideConfig* config_;
  const Hindrances* hindrances_;
  const Reaction* reaction_;
};

}  // namespace echoway::guidance
