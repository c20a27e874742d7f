#include <algorithm>
#include <utility>

#include "echoway/routing/router.hpp"
#include "routing/room_graph.hpp"

namespace echoway {

Router::Router(const Building& building, const RouterConfig& config) : building_(&building), config_(config) {
  add_rooms();
  add_doors_and_links();
  index_edges();
}

void Router::add_edge(std::int32_t a, std::int32_t b, double cost, double clearance, bool stairs) {
  const auto narrowed = static_cast<float>(clearance);
  pending_.push_back({a, {b, narrowed, cost, stairs}});
  pending_.push_back({b, {a, narrowed, cost, stairs}});
}

void Router::add_rooms() {
  const std::size_t rooms = building_->rooms.size();
  spaces_.reserve(rooms);
  room_begin_.assign(1, 0);
  // Doors and links come after all rooms' nodes; remember who leads to them.
  struct Lead {
    std::int32_t node;
    routing::RoomNode room_node;
  };
  std::vector<Lead> leads;
  for (std::size_t r = 0; r < rooms; ++r) {
    const auto room = static_cast<RoomIndex>(r);
    spaces_.emplace_back(*building_, room);
    const routing::RoomGraph graph = routing::build_room_graph(*building_, room, spaces_.back(), config_);
    const auto first = static_cast<std::int32_t>(nodes_.size());
    for (const routing::RoomNode& n : graph.nodes) {
      if (n.portal != routing::PortalKind::none) leads.push_back({static_cast<std::int32_t>(nodes_.size()), n});
      const double radius = config_.clearances[static_cast<std::size_t>(n.step)].radius;
      nodes_.push_back({room, n.position, radius, WaypointKind::turn, -1});
    }
    for (const routing::RoomEdge& e : graph.edges) add_edge(first + e.from, first + e.to, e.cost, e.clearance);
    room_begin_.push_back(static_cast<std::int32_t>(nodes_.size()));
  }
  const auto doors_at = static_cast<std::int32_t>(nodes_.size());
  const auto links_at = doors_at + static_cast<std::int32_t>(building_->doors.size());
  for (const Lead& lead : leads) {
    const routing::RoomNode& n = lead.room_node;
    const std::int32_t portal = n.portal == routing::PortalKind::door     ? doors_at + n.portal_index
                                : n.portal == routing::PortalKind::link_a ? links_at + 2 * n.portal_index
                                                                          : links_at + 2 * n.portal_index + 1;
    const ClearanceStep& step = config_.clearances[static_cast<std::size_t>(n.step)];
    add_edge(lead.node, portal, distance(n.position, n.portal_at) * step.cost_factor, step.radius);
  }
}

double Router::link_cost(const LevelLink& link) const noexcept {
  return link.kind == LevelLinkKind::stairs ? config_.stairs_cost_m : config_.elevator_cost_m;
}

void Router::add_doors_and_links() {
  const auto centre_of = [this](RoomIndex room, std::size_t door, Vec2 fallback) {
    if (!building_->has_room(room)) return fallback;
    for (const Passage& passage : space(room).passages()) {
      if (passage.door == static_cast<std::int32_t>(door)) return passage.centre;
    }
    return fallback;
  };
  for (std::size_t i = 0; i < building_->doors.size(); ++i) {
    const Door& door = building_->doors[i];
    door_node_.push_back(static_cast<std::int32_t>(nodes_.size()));
    nodes_.push_back({door.room_a, door.at_a, 0.0, WaypointKind::door, static_cast<std::int32_t>(i)});
    door_centre_.push_back({centre_of(door.room_a, i, door.at_a), centre_of(door.room_b, i, door.at_b)});
  }
  for (std::size_t i = 0; i < building_->links.size(); ++i) {
    const LevelLink& link = building_->links[i];
    const auto end = static_cast<std::int32_t>(nodes_.size());
    link_node_.push_back(end);
    nodes_.push_back({link.room_a, link.at_a, 0.0, WaypointKind::link_from, static_cast<std::int32_t>(i)});
    nodes_.push_back({link.room_b, link.at_b, 0.0, WaypointKind::link_from, static_cast<std::int32_t>(i)});
    add_edge(end, end + 1, link_cost(link), config_.clearances.front().radius, link.kind == LevelLinkKind::stairs);
  }
}

void Router::index_edges() {
  std::stable_sort(pending_.begin(), pending_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  edge_begin_.assign(nodes_.size() + 1, 0);
  edges_.reserve(pending_.size());
  for (const auto& [from, edge] : pending_) {
    ++edge_begin_[static_cast<std::size_t>(from) + 1];
    edges_.push_back(edge);
  }
  for (std::size_t i = 1; i < edge_begin_.size(); ++i) edge_begin_[i] += edge_begin_[i - 1];
  pending_.clear();
  pending_.shrink_to_fit();
}

}  // namespace echoway
