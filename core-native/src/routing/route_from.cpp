#include <algorithm>
#include <limits>

#include "building/phrases.hpp"
#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

/// Whether a walker at `start` can go straight to a node of the same room, or through the door that the node is.
bool Router::reaches(const Spot& start, std::int32_t index, double radius) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  const FreeSpace& free = space(start.room);
  if (node.kind != WaypointKind::door) return free.clear_between(start.at, node.at, radius);
  for (const Passage& passage : free.passages()) {
    if (passage.door == node.index) return free.clear_to_door(start.at, passage, radius);
  }
  return false;
}

Router::Connection Router::connect_directly(const Spot& start, const RouteTree& tree) const {
  Connection best{0, kInfinity, 0.0};
  for (std::size_t t = 0; t < tree.targets.size(); ++t) {
    const RouteTree::Target& target = tree.targets[t];
    if (target.spot.room != start.room) continue;
    const double cost = distance(start.at, target.spot.at);
    // Nothing is walked, so nothing is passed more closely than usual.
    if (target.goal.kind == Goal::Kind::room) {
      return {-1 - static_cast<std::int32_t>(t), 0.0, config_.clearances.front().radius};
    }
    if (cost >= best.cost) continue;
    for (const ClearanceStep& step : config_.clearances) {
      if (cost * step.cost_factor >= best.cost) break;
      if (!space(start.room).clear_between(start.at, target.spot.at, step.radius)) continue;
      best = {-1 - static_cast<std::int32_t>(t), cost * step.cost_factor, step.radius};
      break;
    }
  }
  return best;
}

/// The cheapest first leg. Nodes are tried in order of what a way over them would cost, so that the first one that can
/// be reached is the best and few are looked at.
Router::Connection Router::connect(const Spot& start, const RouteTree& tree, const BoundFor& bound_for) const {
  const Connection direct = connect_directly(start, tree);
  const std::int32_t begin = room_begin_[static_cast<std::size_t>(start.room)];
  const std::int32_t end = room_begin_[static_cast<std::size_t>(start.room) + 1];
  const auto& passages = space(start.room).passages();
  const auto count = (end - begin) + static_cast<std::int32_t>(passages.size());
  const auto candidate = [&](std::int32_t i) {
    return i < end - begin
               ? begin + i
               : door_node_[static_cast<std::size_t>(passages[static_cast<std::size_t>(i - (end - begin))].door)];
  };
  const auto detour = [&](std::int32_t n) {
    const std::int32_t out = tree.way_out[static_cast<std::size_t>(n)];
    const Node* node = out < 0 ? nullptr : &nodes_[static_cast<std::size_t>(out)];
    const bool bound = node != nullptr && node->kind == bound_for.kind && node->index == bound_for.index;
    return bound ? 0.0 : bound_for.worth_m;
  };
  const auto cost_over = [&](std::int32_t i) {
    const std::int32_t n = candidate(i);
    const Vec2 at = i < end - begin ? nodes_[static_cast<std::size_t>(n)].at
                                    : passages[static_cast<std::size_t>(i - (end - begin))].centre;
    return distance(start.at, at) + tree.cost[static_cast<std::size_t>(n)] + detour(n);
  };
  for (const bool squeeze : {false, true}) {
    double tried_cost = -1.0;
    std::int32_t tried = -1;
    while (true) {
      Connection next{-1, direct.cost, 0.0};
      for (std::int32_t i = 0; i < count; ++i) {
        const double cost = cost_over(i);
        const bool after_tried = cost > tried_cost || (cost == tried_cost && i > tried);
        if (after_tried && cost < next.cost) next = {i, cost, 0.0};
      }
      if (next.node < 0) break;
      tried = next.node;
      tried_cost = next.cost;
      const std::int32_t n = candidate(next.node);
      const Node& node = nodes_[static_cast<std::size_t>(n)];
      const double full = node.kind == WaypointKind::door ? config_.clearances.front().radius : node.radius;
      const double radius = squeeze ? config_.clearances.back().radius : full;
      if (reaches(start, n, radius)) return {n, next.cost - detour(n), radius};
    }
    if (direct.cost < kInfinity) return direct;
  }
  return {0, kInfinity, 0.0};
}

Waypoint Router::through_door(std::int32_t index, RoomIndex from) const {
  const Door& door = building_->doors[static_cast<std::size_t>(index)];
  const auto& [at_a, at_b] = door_centre_[static_cast<std::size_t>(index)];
  if (door.room_a == from) return {from, at_a, WaypointKind::door, index, door.room_b, at_b};
  return {from, at_b, WaypointKind::door, index, door.room_a, at_a};
}

void Router::append(const Waypoint& waypoint, Route& route) const {
  if (!route.waypoints.empty()) {
    const Waypoint& last = route.waypoints.back();
    const Vec2 from = last.kind == WaypointKind::door ? last.next_at : last.at;
    const bool over_link = waypoint.kind == WaypointKind::link_to;
    const LevelLink* link = over_link ? &building_->links[static_cast<std::size_t>(waypoint.index)] : nullptr;
    route.length_m += link != nullptr ? link_cost(*link) : distance(from, waypoint.at);
    if (link != nullptr) (link->kind == LevelLinkKind::stairs ? route.uses_stairs : route.uses_elevator) = true;
  }
  route.waypoints.push_back(waypoint);
}

void Router::follow(const Spot& start, const RouteTree& tree, const Connection& first, Route& route) const {
  append({start.room, start.at, WaypointKind::start, -1, kNoRoom, {}}, route);
  route.cost = first.cost;
  route.clearance_m = first.clearance;
  RoomIndex room = start.room;
  std::int32_t n = first.node;
  std::int32_t previous = -1;
  while (n >= 0) {
    const Node& node = nodes_[static_cast<std::size_t>(n)];
    for (std::int32_t e = previous < 0 ? 0 : edge_begin_[static_cast<std::size_t>(previous)];
         previous >= 0 && e < edge_begin_[static_cast<std::size_t>(previous) + 1]; ++e) {
      const Edge& edge = edges_[static_cast<std::size_t>(e)];
      if (edge.to == n) route.clearance_m = std::min(route.clearance_m, static_cast<double>(edge.clearance));
    }
    if (node.kind == WaypointKind::door) {
      append(through_door(node.index, room), route);
      room = route.waypoints.back().next_room;
    } else if (node.kind == WaypointKind::link_from) {
      const bool landed = !route.waypoints.empty() && route.waypoints.back().kind == WaypointKind::link_from &&
                          route.waypoints.back().index == node.index;
      append({node.room, node.at, landed ? WaypointKind::link_to : WaypointKind::link_from, node.index, kNoRoom, {}},
             route);
      room = node.room;
    } else {
      append({node.room, node.at, WaypointKind::turn, -1, kNoRoom, {}}, route);
      room = node.room;
    }
    previous = n;
    n = tree.next[static_cast<std::size_t>(n)];
  }
  const RouteTree::Target& target = tree.targets[static_cast<std::size_t>(-1 - n)];
  route.goal = target.goal;
  // Anywhere in a room will do: whoever is inside has arrived.
  const bool already_there = previous < 0 && target.goal.kind == Goal::Kind::room;
  append({target.spot.room, already_there ? start.at : target.spot.at, WaypointKind::goal, -1, kNoRoom, {}},
         route);
}

Status Router::route_from(const Spot& from, const RouteTree& tree, Route& route, const BoundFor& bound_for) const {
  route.clear();
  if (!building_->has_room(from.room) || !is_finite(from.at)) {
    return Error{"the start lies in no room of this building"};
  }
  if (tree.cost.size() != nodes_.size() || tree.targets.empty()) return Error{"no destination is set"};
  Spot start = from;
  const FreeSpace& free = space(from.room);
  if (!free.contains(start.at) || free.clearance(start.at, 0.02) < 0.02) start.at = free.settle(start.at, 0.02);
  Connection first = connect(start, tree, bound_for);
  if (!(first.cost < kInfinity)) {  // in a gap that hardly lets a walker through: from before it
    start.at = free.settle(start.at, config_.clearances.front().radius);
    first = connect(start, tree, bound_for);
  }
  if (!(first.cost < kInfinity)) {
    return Error{"no safe way leads from " + room_label(*building_, from.room) + " to the destination in " +
                 room_label(*building_, tree.targets.front().spot.room) +
                 ": no open doors or stairs join them, or a passage is narrower than the wearer"};
  }
  follow(start, tree, first, route);
  return success();
}

Result<Route> Router::find_route(const Spot& from, const Goal& goal, RoutePreferences preferences) const {
  const Result<RouteTree> tree = tree_to(goal, preferences);
  if (!tree) return tree.error();
  Route route;
  const Status status = route_from(from, *tree, route);
  if (!status) return status.error();
  return route;
}

double walked_length(const Route& route) noexcept {
  double length = 0.0;
  for (std::size_t i = 1; i < route.waypoints.size(); ++i) {
    const Waypoint& last = route.waypoints[i - 1];
    const Waypoint& here = route.waypoints[i];
    if (here.kind == WaypointKind::link_to) continue;
    length += distance(last.kind == WaypointKind::door ? last.next_at : last.at, here.at);
  }
  return length;
}

}  // namespace echoway
