#include "guidance/side_step.hpp"

#include <array>
#include <cmath>

#include "guidance/spoken_turn.hpp"
#include "guidance/surroundings.hpp"

namespace echoway::guidance {

namespace {

/// Whether the step touches nothing, neither of the plan nor beyond it.
bool is_free(const Router& router, const GuideConfig& config, const Way& way, const Estimate& from, Vec2 to) {
  const Segment step{from.pose.position, to};
  return router.space(from.room).clear_between(step.a, step.b, config.body_m) && !way.hindrances().hinders(step);
}

}  // namespace

std::optional<SideStep> find_side_step(const Router& router, const GuideConfig& config, const Outlook& outlook,
                                       const Aim& aim, const Way& way, const View& view, const Demand& demand) {
  constexpr std::array<double, 4> kSteps{0.35, 0.6, 0.9, 1.3};
  constexpr double kMetresPerRadian = 0.4;
  const Pose2& pose = view.estimate->pose;
  const Cue turn = make_cue(CueKind::turn);
  const Outlook::Approach from_here = outlook.approach(view, turn, demand);
  const auto can_turn_from = [&](const Pose2& there) {
    Estimate then = *view.estimate;
    then.pose = there;
    const View seen{.estimate = &then, .now = view.now};
    const double off = understood(told(direction_to(there, view.target)));
    return aim.in_reach(then, view.target) && outlook.clear_ahead(seen, turn, off, demand);
  };
  std::optional<SideStep> best;
  double least = 1e300;
  for (const double direction : kSpokenDirections) {
    for (const double step : kSteps) {
      const Vec2 there = pose.position + step * unit_from_angle(pose.heading + direction);
      const double cost = step + std::abs(wrap_angle(direction - view.off)) * kMetresPerRadian;
      if (cost >= least || !is_free(router, config, way, *view.estimate, there)) continue;
      if (!can_turn_from({there, wrap_angle(pose.heading + direction)})) continue;
      if (!outlook.clear_of_walls(view, from_here, direction, demand)) continue;
      least = cost;
      best = {direction, step};
    }
  }
  return best;
}

std::optional<SideStep> find_room(const Router& router, const GuideConfig& config, const Outlook& outlook,
                                  const Way& way, const View& view, const Demand& demand) {
  constexpr double kStep = 0.5;
  constexpr double kEnough = 1.0;
  constexpr double kGain = 0.1;
  const FreeSpace& space = router.space(view.estimate->room);
  const Pose2& pose = view.estimate->pose;
  const Outlook::Approach from_here = outlook.approach(view, make_cue(CueKind::turn), demand);
  double most = space.clearance(pose.position, kEnough) + kGain;
  std::optional<SideStep> best;
  for (const double direction : kSpokenDirections) {
    const Vec2 there = pose.position + kStep * unit_from_angle(pose.heading + direction);
    const double clear = space.clearance(there, kEnough);
    if (clear <= most || !is_free(router, config, way, *view.estimate, there)) continue;
    if (!outlook.clear_of_walls(view, from_here, direction, demand)) continue;
    most = clear;
    best = {direction, kStep};
  }
  return best;
}

}  // namespace echoway::guidance
