#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "building/phrases.hpp"
#include "echoway/building/opening.hpp"
#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

constexpr std::int32_t kNoDoor = -1;

/// `the door between rooms 'hall' and 'store' is 0.25 m wide, and a person needs 0.4 m`
std::string too_narrow(const Building& building, const Door& door) {
  const Phrases phrases(building.unit);
  return door_label(building, door) + " is " + phrases.length(door.width) + " wide, and a person needs " +
         phrases.length(kNarrowestDoor);
}

std::string why_closed(const Building& building, RoomIndex room) {
  const Door* widest = nullptr;
  for (const Door& door : building.doors) {
    if (door.room_a != room && door.room_b != room) continue;
    if (widest == nullptr || door.width > widest->width) widest = &door;
  }
  if (widest != nullptr && !is_passable(*widest)) return too_narrow(building, *widest);
  return "no door, stairs or elevator of the building is joined to it";
}

/// Which rooms hang together with one, and by which doors that nobody passes.
class Neighbourhood {
 public:
  Neighbourhood(const Building& building, RoomIndex from)
      : building_(building), reached_(building.rooms.size(), false), closed_(building.rooms.size(), kNoDoor) {
    std::deque<std::pair<RoomIndex, std::int32_t>> queue{{from, kNoDoor}};
    while (!queue.empty()) {
      const auto [room, closed] = queue.front();
      queue.pop_front();
      if (!building_.has_room(room) || reached_[static_cast<std::size_t>(room)]) continue;
      reached_[static_cast<std::size_t>(room)] = true;
      closed_[static_cast<std::size_t>(room)] = closed;
      spread(room, closed, queue);
    }
  }

  [[nodiscard]] bool reaches(RoomIndex room) const { return reached_[static_cast<std::size_t>(room)]; }
  /// The first door on the way to `room` that nobody passes, where every way has one.
  [[nodiscard]] const Door* closed(RoomIndex room) const {
    const std::int32_t door = closed_[static_cast<std::size_t>(room)];
    return door < 0 ? nullptr : &building_.doors[static_cast<std::size_t>(door)];
  }

 private:
  // What can be walked comes before what cannot, so that each room is reached by as much walking as there is.
  void spread(RoomIndex room, std::int32_t closed, std::deque<std::pair<RoomIndex, std::int32_t>>& queue) const {
    for (std::size_t i = 0; i < building_.doors.size(); ++i) {
      const Door& door = building_.doors[i];
      if (door.room_a != room && door.room_b != room) continue;
      if (is_passable(door)) {
        queue.push_front({door.beyond(room), closed});
      } else {
        queue.push_back({door.beyond(room), closed == kNoDoor ? static_cast<std::int32_t>(i) : closed});
      }
    }
    for (const LevelLink& link : building_.links) {
      if (link.room_a == room || link.room_b == room) queue.push_front({link.beyond(room), closed});
    }
  }

  const Building& building_;
  std::vector<bool> reached_;
  std::vector<std::int32_t> closed_;
};

std::string why_no_way(const Building& building, RoomIndex from, RoomIndex to, const RouterConfig& config) {
  const Neighbourhood about(building, from);
  if (!about.reaches(to)) return "no doors, stairs or elevators join them";
  if (const Door* door = about.closed(to)) return too_narrow(building, *door);
  return "what is free on the way is narrower than " +
         Phrases(building.unit).length(2.0 * config.clearances.back().radius);
}

}  // namespace

bool Router::is_joined(RoomIndex room) const {
  for (std::int32_t n = room_begin_[static_cast<std::size_t>(room)];
       n < room_begin_[static_cast<std::size_t>(room) + 1]; ++n) {
    if (leads_out(n)) return true;
  }
  return false;
}

bool Router::may_lead(RoomIndex room, const RouteTree& tree) const {
  const auto begin = tree.cost.begin() + room_begin_[static_cast<std::size_t>(room)];
  const auto end = tree.cost.begin() + room_begin_[static_cast<std::size_t>(room) + 1];
  return std::any_of(begin, end, [](double cost) { return std::isfinite(cost); }) ||
         std::any_of(tree.targets.begin(), tree.targets.end(),
                     [room](const RouteTree::Target& target) { return target.spot.room == room; });
}

Status Router::check_goal(const RouteTree& tree, RoomIndex here) const {
  if (tree.targets.empty()) return Error{"no destination is set"};
  if (building_->rooms.size() == 1) return success();
  for (const RouteTree::Target& target : tree.targets) {
    if (target.spot.room == here || is_joined(target.spot.room)) return success();
  }
  const RoomIndex closed = tree.targets.front().spot.room;
  return Error{"nothing leads into " + room_label(*building_, closed) + ": " + why_closed(*building_, closed)};
}

Status Router::check_way(RoomIndex room, std::optional<Vec2> at, const RouteTree& tree) const {
  if (tree.targets.empty()) return Error{"no destination is set"};
  Route route;
  if (at ? route_from({room, *at}, tree, route).ok() : may_lead(room, tree)) return success();
  const RoomIndex to = tree.targets.front().spot.room;
  return Error{"no safe way leads from " + room_label(*building_, room) + " to the destination in " +
               room_label(*building_, to) + ": " + why_no_way(*building_, room, to, config_)};
}

}  // namespace echoway
