#include "ways.hpp"

namespace echoway::proof {

Route ends_of(const Route& way) {
  Route ends;
  for (const Waypoint& w : {way.waypoints.front(), way.waypoints.back()}) {
    for (const WaypointKind kind : {WaypointKind::link_to, WaypointKind::turn}) {
      ends.waypoints.push_back(w);
      ends.waypoints.back().kind = kind;
    }
  }
  return ends;
}

std::optional<double> shortest_round_things(const Building& plan, TrackedPose& world, const Spot& start,
                                            const Spot& end) {
  Building furnished = plan;
  for (std::size_t i = 0; i < furnished.rooms.size(); ++i) {
    for (const Segment& s : world.things(static_cast<RoomIndex>(i))) {
      // A post has no length, which a wall needs.
      const Vec2 b = s.length() > 0.0 ? s.b : s.b + Vec2{0.01, 0.0};
      furnished.rooms[i].reflectors.push_back({s.a, b});
    }
  }
  const Router router(furnished);
  const Result<Route> way = router.find_route(start, {Goal::Kind::spot, 0, end});
  if (!way) return std::nullopt;
  return walked_length(*way);
}

}  // namespace echoway::proof
