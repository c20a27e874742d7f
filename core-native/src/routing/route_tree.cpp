#include <algorithm>
#include <limits>
#include <queue>

#include "echoway/geometry/box.hpp"
#include "echoway/routing/router.hpp"

namespace echoway {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec2 middle_of(const Room& room) {
  if (room.walls.empty()) return {};
  const Box about = box_about(room.walls);
  return 0.5 * (about.low + about.high);
}

}  // namespace

bool Router::leads_out(std::int32_t node) const {
  const auto begin = edges_.begin() + edge_begin_[static_cast<std::size_t>(node)];
  const auto end = edges_.begin() + edge_begin_[static_cast<std::size_t>(node) + 1];
  return std::any_of(begin, end, [this](const Edge& edge) { return edge.to >= room_begin_.back(); });
}

Spot Router::stand(const Spot& spot) const {
  const FreeSpace& free = space(spot.room);
  for (const ClearanceStep& step : config_.clearances) {
    const Vec2 p = free.settle(spot.at, step.radius);
    if (free.clearance(p, step.radius) >= step.radius - 1e-6) return {spot.room, p};
  }
  return {spot.room, free.settle(spot.at, config_.clearances.back().radius)};
}

std::vector<RouteTree::Target> Router::targets_of(const Goal& goal) const {
  std::vector<RouteTree::Target> targets;
  const auto add = [&](Goal::Kind kind, std::size_t index, RoomIndex room, Vec2 at) {
    if (!building_->has_room(room) || !is_finite(at)) return;
    targets.push_back({{kind, static_cast<std::int32_t>(index), {}}, stand({room, at})});
  };
  const auto add_landmark = [&](Goal::Kind kind, const std::vector<Landmark>& all, std::size_t index) {
    if (index < all.size()) add(kind, index, all[index].room, all[index].at);
  };
  switch (goal.kind) {
    case Goal::Kind::spot:
      add(goal.kind, 0, goal.spot.room, goal.spot.at);
      if (!targets.empty()) targets.back().goal = goal;
      break;
    case Goal::Kind::place:
      add_landmark(goal.kind, building_->places, static_cast<std::size_t>(goal.index));
      break;
    case Goal::Kind::exit:
      add_landmark(goal.kind, building_->exits, static_cast<std::size_t>(goal.index));
      break;
    case Goal::Kind::nearest_exit:
      for (std::size_t i = 0; i < building_->exits.size(); ++i) add_landmark(Goal::Kind::exit, building_->exits, i);
      break;
    case Goal::Kind::room:
      if (!building_->has_room(goal.index)) break;
      // A room is reached in front of any of its doors or stairs, on the inside.
      for (std::int32_t n = room_begin_[static_cast<std::size_t>(goal.index)];
           n < room_begin_[static_cast<std::size_t>(goal.index) + 1]; ++n) {
        if (leads_out(n)) targets.push_back({goal, {goal.index, nodes_[static_cast<std::size_t>(n)].at}});
      }
      // Where nothing leads in, whoever is inside has arrived.
      if (targets.empty()) targets.push_back({goal, stand({goal.index, middle_of(building_->room(goal.index))})});
      break;
  }
  return targets;
}

Result<RouteTree> Router::tree_to(const Goal& goal, RoutePreferences preferences) const {
  RouteTree tree;
  tree.goal = goal;
  tree.preferences = preferences;
  tree.targets = targets_of(goal);
  if (tree.targets.empty()) {
    switch (goal.kind) {
      case Goal::Kind::nearest_exit:
      case Goal::Kind::exit:
        return Error{"this building names no such exit; add a line `exit R x y \"name\"` to its building.cfg"};
      case Goal::Kind::place:
        return Error{"this building names no such place; add a line `place R x y \"name\"` to its building.cfg"};
      case Goal::Kind::room:
        return Error{"this building has no such room"};
      case Goal::Kind::spot:
        return Error{"the destination lies in no room of this building"};
    }
  }
  seed_tree(tree);
  grow_tree(tree);
  return tree;
}

void Router::seed_tree(RouteTree& tree) const {
  tree.cost.assign(nodes_.size(), kInfinity);
  tree.next.assign(nodes_.size(), 0);
  tree.way_out.assign(nodes_.size(), -1);
  for (std::size_t t = 0; t < tree.targets.size(); ++t) {
    const Spot& spot = tree.targets[t].spot;
    const FreeSpace& free = space(spot.room);
    const auto begin = room_begin_[static_cast<std::size_t>(spot.room)];
    const auto end = room_begin_[static_cast<std::size_t>(spot.room) + 1];
    bool any = false;
    // A target too close to things for the usual clearance is approached as closely as need be.
    for (const bool squeeze : {false, true}) {
      for (std::int32_t n = begin; n < end && !(squeeze && any); ++n) {
        const Node& node = nodes_[static_cast<std::size_t>(n)];
        const double radius = squeeze ? config_.clearances.back().radius : node.radius;
        if (!free.clear_between(node.at, spot.at, radius)) continue;
        any = true;
        const double cost = distance(node.at, spot.at);
        if (cost >= tree.cost[static_cast<std::size_t>(n)]) continue;
        tree.cost[static_cast<std::size_t>(n)] = cost;
        tree.next[static_cast<std::size_t>(n)] = -1 - static_cast<std::int32_t>(t);
      }
      if (any) break;
    }
  }
}

void Router::grow_tree(RouteTree& tree) const {
  // Dijkstra from the targets outwards; ties go to the lower node, so that every run gives the same tree.
  using Entry = std::pair<double, std::int32_t>;
  std::vector<Entry> store;
  store.reserve(nodes_.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue(std::greater<>{}, std::move(store));
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (tree.cost[n] < kInfinity) queue.push({tree.cost[n], static_cast<std::int32_t>(n)});
  }
  while (!queue.empty()) {
    const auto [cost, n] = queue.top();
    queue.pop();
    if (cost > tree.cost[static_cast<std::size_t>(n)]) continue;
    const WaypointKind kind = nodes_[static_cast<std::size_t>(n)].kind;
    const std::int32_t next = tree.next[static_cast<std::size_t>(n)];
    const bool out = kind == WaypointKind::door || kind == WaypointKind::link_from;
    tree.way_out[static_cast<std::size_t>(n)] = out ? n : next < 0 ? -1 : tree.way_out[static_cast<std::size_t>(next)];
    for (std::int32_t e = edge_begin_[static_cast<std::size_t>(n)]; e < edge_begin_[static_cast<std::size_t>(n) + 1];
         ++e) {
      const Edge& edge = edges_[static_cast<std::size_t>(e)];
      const bool avoided = edge.stairs && tree.preferences.avoid_stairs;
      const double through = cost + edge.cost + (avoided ? config_.avoided_cost_m : 0.0);
      const auto to = static_cast<std::size_t>(edge.to);
      if (through >= tree.cost[to]) continue;
      tree.cost[to] = through;
      tree.next[to] = n;
      queue.push({through, edge.to});
    }
  }
}

}  // namespace echoway
