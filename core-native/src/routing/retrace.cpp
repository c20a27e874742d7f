#include <algorithm>

#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

/// Crumbs closer than this to each other, in one room, close a loop that need not be walked again, metres.
constexpr double kSamePlace = 0.8;

}  // namespace

Result<Route> Router::retrace(const Spot& from, std::span<const Spot> crumbs) const {
  const auto usable = [this](const Spot& s) { return building_->has_room(s.room) && is_finite(s.at); };
  if (!usable(from) || !std::all_of(crumbs.begin(), crumbs.end(), usable)) {
    return Error{"the way back leads through a room that this building does not have"};
  }
  if (crumbs.empty()) return Error{"there is no way back yet: nothing has been walked"};

  Route route;
  route.clear();
  route.goal = {Goal::Kind::spot, 0, crumbs.front()};
  append({from.room, from.at, WaypointKind::start, -1, kNoRoom, {}}, route);
  route.clearance_m = config_.clearances.front().radius;

  const auto sees = [this](const Spot& a, const Spot& b) {
    return a.room == b.room && space(a.room).clear_between(a.at, b.at, config_.clearances.back().radius);
  };
  Spot here = from;
  auto left = static_cast<std::ptrdiff_t>(crumbs.size());  // crumbs [0, left) are still to be passed
  while (left > 0) {
    // Passing the place of an older crumb again, or seeing it: everything in between was a detour.
    std::ptrdiff_t to = left - 1;
    for (std::ptrdiff_t i = 0; i < left - 1; ++i) {
      const Spot& crumb = crumbs[static_cast<std::size_t>(i)];
      const bool same = crumb.room == here.room && distance(crumb.at, here.at) < kSamePlace;
      if (!same && !sees(here, crumb)) continue;
      to = i;
      break;
    }
    const Spot& next = crumbs[static_cast<std::size_t>(to)];
    left = to;
    if (sees(here, next)) {
      append({next.room, next.at, left == 0 ? WaypointKind::goal : WaypointKind::turn, -1, kNoRoom, {}}, route);
      here = next;
      continue;
    }
    const Result<Route> leg = find_route(here, {Goal::Kind::spot, 0, next});
    if (!leg) return leg.error();
    for (std::size_t i = 1; i < leg->waypoints.size(); ++i) {
      Waypoint waypoint = leg->waypoints[i];
      if (waypoint.kind == WaypointKind::goal) {
        waypoint.kind = left == 0 ? WaypointKind::goal : WaypointKind::turn;
        here = {waypoint.room, waypoint.at};
      }
      append(waypoint, route);
    }
    route.clearance_m = std::min(route.clearance_m, leg->clearance_m);
  }
  route.cost = route.length_m;
  return route;
}

}  // namespace echoway
