#include "plan/floor_plan.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace echoway::sim {
namespace {

constexpr double kApproach = 0.4;  // How far before a doorway the wearer lines up with it, metres.

std::string not_reachable(const Room& from, const Room& to) {
  return "no way through doors leads from room " + from.id + " to room " + to.id;
}

}  // namespace

FloorPlan::FloorPlan(const Building& building) : building_(building), doorways_(find_doorways(building)) {}

const std::vector<Doorway>& FloorPlan::doorways(RoomIndex room) const {
  return doorways_[static_cast<std::size_t>(room)];
}

const RoomGrid& FloorPlan::grid(RoomIndex room) const {
  return grids_.try_emplace(room, building_.room(room)).first->second;
}

// Dijkstra over doorways; returns, for each room on the way, the doorway (index in that room) by which it is left.
std::vector<std::size_t> FloorPlan::door_chain(RoomIndex from_room, Vec2 from, RoomIndex to_room) const {
  const std::size_t count = building_.rooms.size();
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  std::vector<Vec2> entry(count);
  std::vector<RoomIndex> before(count, kNoRoom);
  std::vector<std::size_t> door(count, 0);
  using Entry = std::pair<double, RoomIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto at = [](RoomIndex room) { return static_cast<std::size_t>(room); };
  cost[at(from_room)] = 0.0;
  entry[at(from_room)] = from;
  open.emplace(0.0, from_room);
  while (!open.empty()) {
    const auto [reached, room] = open.top();
    open.pop();
    if (reached > cost[at(room)]) continue;
    if (room == to_room) break;
    for (std::size_t i = 0; i < doorways(room).size(); ++i) {
      const Doorway& doorway = doorways(room)[i];
      const double total = reached + distance(entry[at(room)], doorway.centre) + 0.5;
      if (total >= cost[at(doorway.other)]) continue;
      cost[at(doorway.other)] = total;
      entry[at(doorway.other)] = doorways(doorway.other)[doorway.twin].centre;
      before[at(doorway.other)] = room;
      door[at(doorway.other)] = i;
      open.emplace(total, doorway.other);
    }
  }
  std::vector<std::size_t> chain;
  for (RoomIndex room = to_room; room != from_room; room = before[at(room)]) {
    if (before[at(room)] == kNoRoom) return {};
    chain.push_back(door[at(room)]);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

Result<std::vector<Stretch>> FloorPlan::route(RoomIndex from_room, Vec2 from, RoomIndex to_room, Vec2 to) const {
  const std::vector<std::size_t> chain = door_chain(from_room, from, to_room);
  if (chain.empty() && from_room != to_room) {
    return Error{not_reachable(building_.room(from_room), building_.room(to_room))};
  }
  std::vector<Stretch> stretches;
  RoomIndex room = from_room;
  Vec2 here = from;
  for (const std::size_t index : chain) {
    const Doorway& doorway = doorways(room)[index];
    const Vec2 approach = doorway.centre + kApproach * doorway.inward;
    Stretch stretch{room, grid(room).path(here, approach)};
    if (stretch.points.empty()) {
      return Error{"no way in room " + building_.room(room).id + " leads to its door to room " +
                   building_.room(doorway.other).id};
    }
    stretch.points.push_back(doorway.centre);
    stretches.push_back(std::move(stretch));
    const Doorway& twin = doorways(doorway.other)[doorway.twin];
    room = doorway.other;
    here = twin.centre + kApproach * twin.inward;
    stretches.push_back({room, {here}});
  }
  Stretch last{room, grid(room).path(here, to)};
  if (last.points.empty()) {
    return Error{"a place in room " + building_.room(room).id + " is in a wall, outside or cannot be reached"};
  }
  stretches.push_back(std::move(last));
  return stretches;
}

}  // namespace echoway::sim
