#pragma once

#include <optional>

#include "guidance/aim.hpp"
#include "guidance/outlook.hpp"
#include "guidance/way.hpp"

namespace echoway::guidance {

/// A step or two to where a turn can be told.
struct SideStep {
  double direction = 0.0;  ///< From the chest, the middle of a sector.
  double length_m = 0.0;
};

/// The cheapest one for somebody who stands in too tight a spot to be turned to their target: free, short, in about the
/// right direction, and leading to where the turn leaves as much room as is demanded. None where no step does.
[[nodiscard]] std::optional<SideStep> find_side_step(const Router& router, const GuideConfig& config,
                                                     const Outlook& outlook, const Aim& aim, const Way& way,
                                                     const View& view, const Demand& demand);

/// Where to go from a spot that allows neither the turn nor a step towards it: to where the nearest wall is farthest.
/// None where no step makes more room.
[[nodiscard]] std::optional<SideStep> find_room(const Router& router, const GuideConfig& config, const Outlook& outlook,
                                                const Way& way, const View& view, const Demand& demand);

}  // namespace echoway::guidance
