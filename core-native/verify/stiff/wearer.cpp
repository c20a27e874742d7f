#include "stiff/wearer.hpp"

#include <utility>

#include "plans/error_of.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"

namespace echoway::stiff {
Wearer wearer(double duration_s, const BeltConfig& belt) {
  Wearer w;
  w.building = plans::three_rooms();
  sim::Walk walk;
  walk.seed = 21;
  walk.start = {"hall", {1.2, 1.5}};
  walk.belt = belt;
  walk.world = sim::make_world(sim::Profile::empty);
  const double hall_and_back = 24.0;
  for (double planned = 0.0; planned < duration_s; planned += hall_and_back) {
    walk.add(sim::GoTo{{"office", {1.5, 1.2}}});
    walk.add(sim::Pause{1.0});
    walk.add(sim::GoTo{{"office", {1.5, 4.0}}});
    walk.add(sim::GoTo{{"hall", {1.2, 1.5}}});
  }
  Result<sim::Simulation> heard = sim::simulate(w.building, walk);
  if (heard) w.walk = std::move(*heard);
  w.config.belt = belt;
  w.config.start = {0, walk.start.at, walk.start_heading};
  w.config.seed = 5;
  return w;
}

Followed follow(const Wearer& wearer, const ChangeFiring& change_firing, const ChangeHint& change_hint,
                const std::function<void(Session&)>& before) {
  Followed result;
  auto opened = Session::open(wearer.building, wearer.config);
  if (!opened) {
    result.broken = opened.error().message;
    return result;
  }
  Session& session = **opened;
  if (before) before(session);
  auto hint = wearer.walk.motion.begin();
  int hints = 0;
  const auto& firings = wearer.walk.scans.firings;
  for (std::size_t i = 0; i < firings.size(); ++i) {
    for (; hint != wearer.walk.motion.end() && hint->time_s <= firings[i].time_s; ++hint) {
      session.on_motion(change_hint ? change_hint(*hint, hints) : *hint);
      ++hints;
    }
    const Firing firing = change_firing ? change_firing(firings[i], static_cast<int>(i)) : firings[i];
    const bool renewed = session.on_firing(firing);
    if (result.broken.empty()) result.broken = plans::broken_promise(session);
    result.estimates += renewed;
    result.last = session.estimate();
    result.error_m = plans::error_of(result.last, wearer.walk.truth[i], wearer.building);
    const bool certain = result.last.state == TrackState::tracking;
    result.false_certainties += certain && result.error_m > 1.0 && result.error_m > 5.0 * result.last.sigma_m;
  }
  if (firings.empty()) result.broken = "the walk could not be simulated";
  return result;
}

}  // namespace echoway::stiff
