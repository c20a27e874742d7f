#include "plan/floor_plan.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace echoway::sim {
namespace {

constexpr double kApproach = 0.4;    // How far before a doorway the wearer lines up with it, metres.
constexpr double kDoorPrice = 0.5;   // A door costs as much as this many metres of way,
constexpr double kLinkPrice = 15.0;  // stairs or an elevator as many.

std::vector<std::vector<Passage>> find_passages(const Building& building,
                                                const std::vector<std::vector<Doorway>>& doorways) {
  std::vector<std::vector<Passage>> passages(building.rooms.size());
  for (std::size_t room = 0; room < passages.size(); ++room) {
    for (std::size_t i = 0; i < doorways[room].size(); ++i) {
      const Doorway& here = doorways[room][i];
      const Doorway& there = doorways[static_cast<std::size_t>(here.other)][here.twin];
      passages[room].push_back({here.other, here.middle(), there.middle(), static_cast<int>(i), -1});
    }
  }
  for (std::size_t i = 0; i < building.links.size(); ++i) {
    const LevelLink& link = building.links[i];
    if (link.room_a == kNoRoom || link.room_b == kNoRoom) continue;
    passages[static_cast<std::size_t>(link.room_a)].push_back(
        {link.room_b, link.at_a, link.at_b, -1, static_cast<int>(i)});
    passages[static_cast<std::size_t>(link.room_b)].push_back(
        {link.room_a, link.at_b, link.at_a, -1, static_cast<int>(i)});
  }
  return passages;
}

}  // namespace

Status check_floors(const Building& building) {
  for (const Room& room : building.rooms) {
    if (!RoomGrid::fits(room)) {
      return Error{"room " + room.id + " is too large to be simulated; check the units of the building"};
    }
  }
  return success();
}

FloorPlan::FloorPlan(const Building& building)
    : building_(building), doorways_(find_doorways(building)), passages_(find_passages(building, doorways_)) {}

const std::vector<Doorway>& FloorPlan::doorways(RoomIndex room) const {
  return doorways_[static_cast<std::size_t>(room)];
}

const std::vector<Passage>& FloorPlan::passages(RoomIndex room) const {
  return passages_[static_cast<std::size_t>(room)];
}

const RoomGrid& FloorPlan::grid(RoomIndex room) const {
  return grids_.try_emplace(room, building_.room(room)).first->second;
}

// Dijkstra over passages, straight lines between them standing for the ways inside a room.
std::vector<Passage> FloorPlan::chain(RoomIndex from_room, Vec2 from, RoomIndex to_room,
                                      const std::set<std::size_t>& shut) const {
  struct Reached {
    double cost = std::numeric_limits<double>::infinity();
    Vec2 entry{};
    RoomIndex before = kNoRoom;
    Passage by{};
  };
  std::vector<Reached> reached(building_.rooms.size());
  const auto of = [&reached](RoomIndex room) -> Reached& { return reached[static_cast<std::size_t>(room)]; };
  using Entry = std::pair<double, RoomIndex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  of(from_room).cost = 0.0;
  of(from_room).entry = from;
  open.emplace(0.0, from_room);
  while (!open.empty()) {
    const auto [cost, room] = open.top();
    open.pop();
    if (cost > of(room).cost) continue;
    if (room == to_room) break;
    for (const Passage& passage : passages(room)) {
      const bool door = passage.doorway >= 0;
      if (door && shut.contains(doorways(room)[static_cast<std::size_t>(passage.doorway)].door)) continue;
      const double total = cost + distance(of(room).entry, passage.leave_at) + (door ? kDoorPrice : kLinkPrice);
      if (total >= of(passage.to).cost) continue;
      of(passage.to) = {total, passage.arrive_at, room, passage};
      open.emplace(total, passage.to);
    }
  }
  std::vector<Passage> passages;
  for (RoomIndex room = to_room; room != from_room; room = of(room).before) {
    if (of(room).before == kNoRoom) return {};
    passages.push_back(of(room).by);
  }
  std::reverse(passages.begin(), passages.end());
  return passages;
}

Result<std::vector<Stretch>> FloorPlan::route(RoomIndex from_room, Vec2 from, RoomIndex to_room, Vec2 to,
                                              const std::set<std::size_t>& shut) const {
  const std::vector<Passage> passages = chain(from_room, from, to_room, shut);
  if (passages.empty() && from_room != to_room) {
    return Error{"no way through open doors leads from room " + building_.room(from_room).id + " to room " +
                 building_.room(to_room).id};
  }
  std::vector<Stretch> stretches;
  RoomIndex room = from_room;
  Vec2 here = from;
  std::vector<Vec2> first;  // Points that a stretch begins with: straight in from the door.
  for (const Passage& passage : passages) {
    Stretch stretch{room, std::move(first), passage};
    first.clear();
    Vec2 target = passage.leave_at;
    if (passage.doorway >= 0) {
      const Doorway& doorway = doorways(room)[static_cast<std::size_t>(passage.doorway)];
      target = doorway.centre() + kApproach * doorway.inward;
    }
    const std::vector<Vec2> way = grid(room).path(here, target);
    if (way.empty()) {
      return Error{"no way in room " + building_.room(room).id + " leads to its passage to room " +
                   building_.room(passage.to).id};
    }
    stretch.points.insert(stretch.points.end(), way.begin(), way.end());
    here = passage.arrive_at;
    if (passage.doorway >= 0) {
      const Doorway& doorway = doorways(room)[static_cast<std::size_t>(passage.doorway)];
      const Doorway& twin = doorways(passage.to)[doorway.twin];
      stretch.points.push_back(doorway.middle());
      here = twin.centre() + kApproach * twin.inward;
      first.push_back(here);
    }
    stretches.push_back(std::move(stretch));
    room = passage.to;
  }
  Stretch last{room, std::move(first), {}};
  const std::vector<Vec2> way = grid(room).path(here, to);
  if (way.empty()) {
    return Error{"the place in room " + building_.room(room).id + " is in a wall, outside or cannot be reached"};
  }
  last.points.insert(last.points.end(), way.begin(), way.end());
  stretches.push_back(std::move(last));
  return stretches;
}

}  // namespace echoway::sim
