#pragma once

#include <cstddef>

#include "echoway/locate/locator.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/tracker/bayes_locator.hpp"

namespace echoway::test {

/// Where and which way round a walk begins, as a wearer who knows it says it.
inline Start start_of(const sim::Simulation& walk, const Building& building) {
  const TruthRow& first = walk.truth.front();
  return {building.find_room(first.room), first.pose.position, first.pose.heading};
}

/// Plays a walk to a locator or a session, each motion hint before the firing that follows it; `after(i)` after firing
/// number i.
template <class Listener, class After>
void play(const sim::Simulation& walk, Listener& listener, After&& after, bool hints = true) {
  std::size_t hint = 0;
  for (std::size_t i = 0; i < walk.scans.firings.size(); ++i) {
    const Firing& firing = walk.scans.firings[i];
    while (hints && hint < walk.motion.size() && walk.motion[hint].time_s <= firing.time_s) {
      listener.on_motion(walk.motion[hint++]);
    }
    listener.on_firing(firing);
    after(i);
  }
}

/// Where the tracker takes the wearer to be after a walk of which it was told the start.
inline RoomIndex room_at_the_end(const Building& building, const sim::Walk& walk) {
  const sim::Simulation simulation = *sim::simulate(building, walk);
  BayesLocator locator(building, simulation.scans.belt.apply_to({}), start_of(simulation, building), {});
  play(simulation, locator, [](std::size_t) {});
  return locator.estimate().room;
}

}  // namespace echoway::test
