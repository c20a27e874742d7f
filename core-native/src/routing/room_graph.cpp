#include "routing/room_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "echoway/building/opening.hpp"
#include "routing/corners.hpp"

namespace echoway::routing {
namespace {

/// Components of an undirected graph.
class UnionFind {
 public:
  void grow(std::size_t size) {
    const std::size_t old = parent_.size();
    parent_.resize(size);
    std::iota(parent_.begin() + static_cast<std::ptrdiff_t>(old), parent_.end(), static_cast<std::int32_t>(old));
  }
  std::int32_t find(std::int32_t i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      auto& p = parent_[static_cast<std::size_t>(i)];
      p = parent_[static_cast<std::size_t>(p)];
      i = p;
    }
    return i;
  }
  void join(std::int32_t i, std::int32_t j) { parent_[static_cast<std::size_t>(find(i))] = find(j); }

 private:
  std::vector<std::int32_t> parent_;
};

struct Portal {
  PortalKind kind = PortalKind::none;
  std::int32_t index = -1;
  Vec2 at{};
  Vec2 inward{};
};

std::vector<Portal> portals_of(const Building& building, RoomIndex room, const FreeSpace& space) {
  std::vector<Portal> portals;
  for (const Passage& p : space.passages()) {
    if (!is_passable(building.doors[static_cast<std::size_t>(p.door)])) continue;
    portals.push_back({PortalKind::door, p.door, p.centre, p.inward});
  }
  for (std::size_t i = 0; i < building.links.size(); ++i) {
    const LevelLink& link = building.links[i];
    const auto index = static_cast<std::int32_t>(i);
    if (link.room_a == room) portals.push_back({PortalKind::link_a, index, link.at_a, {}});
    if (link.room_b == room) portals.push_back({PortalKind::link_b, index, link.at_b, {}});
  }
  return portals;
}

class Builder {
 public:
  Builder(const Building& building, RoomIndex room, const FreeSpace& space, const RouterConfig& config)
      : space_(space),
        ladder_(config.clearances),
        run_up_(config.door_run_up_m),
        portals_(portals_of(building, room, space)) {
    for (const auto* landmarks : {&building.exits, &building.places}) {
      for (const Landmark& l : *landmarks) {
        if (l.room == room) anchors_.push_back(l.at);
      }
    }
  }

  RoomGraph build() {
    for (std::int8_t step = 0; step < kClearanceSteps; ++step) {
      const std::size_t first = graph_.nodes.size();
      add_portals(step);
      add_corners(step);
      components_.grow(graph_.nodes.size());
      connect(first);
      if (hangs_together(step)) break;
    }
    return std::move(graph_);
  }

 private:
  [[nodiscard]] double radius(std::int8_t step) const { return ladder_[static_cast<std::size_t>(step)].radius; }

  [[nodiscard]] bool fits(Vec2 p, double r) const { return space_.clearance(p, r) >= r - 1e-6 && space_.contains(p); }

  void add_portals(std::int8_t step) {
    const double r = radius(step);
    for (const Portal& portal : portals_) {
      Vec2 p = portal.at + std::max(r, run_up_) * portal.inward;
      if (!fits(p, r)) p = portal.at + r * portal.inward;
      if (portal.inward == Vec2{} || !fits(p, r)) {
        p = space_.settle(portal.at + 0.5 * r * portal.inward, r);
      }
      const bool last = step + 1 == kClearanceSteps;
      if (!last && space_.clearance(p, r) < r - 1e-6) continue;
      graph_.nodes.push_back({p, step, portal.kind, portal.index, portal.at, {}});
    }
  }

  void add_corners(std::int8_t step) {
    const double r = radius(step);
    // Doorways count as wall here: no way within the room turns about a door's jamb.
    std::vector<Segment> outline(space_.solids().begin(), space_.solids().end());
    outline.insert(outline.end(), space_.doorways().begin(), space_.doorways().end());
    for (const TurningPoint& turn : turning_points(outline, r)) {
      if (!fits(turn.position, r)) continue;
      graph_.nodes.push_back({turn.position, step, PortalKind::none, -1, {}, turn.sides});
    }
  }

  void connect(std::size_t first) {
    for (std::size_t j = first; j < graph_.nodes.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) connect(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
    }
  }

  void connect(std::int32_t i, std::int32_t j) {
    const RoomNode& a = graph_.nodes[static_cast<std::size_t>(i)];
    const RoomNode& b = graph_.nodes[static_cast<std::size_t>(j)];
    const Vec2 d = b.position - a.position;
    if (a.portal == PortalKind::none && !is_taut(a.sides, d)) return;
    if (b.portal == PortalKind::none && !is_taut(b.sides, d)) return;
    const std::int8_t step = std::max(a.step, b.step);
    const double r = radius(step);
    const bool squeezed = a.portal != PortalKind::none || b.portal != PortalKind::none;
    if (squeezed ? !space_.clear_between(a.position, b.position, r) : !space_.clear(a.position, b.position, r)) return;
    const double length = norm(d);
    graph_.edges.push_back({i, j, length, length * ladder_[static_cast<std::size_t>(step)].cost_factor, r});
    components_.join(i, j);
  }

  /// Every door, stairs and anchor reaches every other.
  [[nodiscard]] bool hangs_together(std::int8_t step) {
    std::int32_t first = -1;
    std::size_t present = 0;
    bool one = true;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (graph_.nodes[i].portal == PortalKind::none) continue;
      present += graph_.nodes[i].step == 0 ? 1 : 0;
      const std::int32_t c = components_.find(static_cast<std::int32_t>(i));
      if (first < 0) first = c;
      one = one && c == first;
    }
    if (present < portals_.size() || !one) return false;
    return std::all_of(anchors_.begin(), anchors_.end(), [&](Vec2 anchor) { return sees_graph(anchor, step); });
  }

  [[nodiscard]] bool sees_graph(Vec2 anchor, std::int8_t step) const {
    if (graph_.nodes.empty()) return true;
    const double r = radius(step);
    const Vec2 p = space_.settle(anchor, r);
    return space_.clearance(p, r) >= r - 1e-6 &&
           std::any_of(graph_.nodes.begin(), graph_.nodes.end(),
                       [&](const RoomNode& n) { return space_.clear_between(p, n.position, r); });
  }

  const FreeSpace& space_;
  ClearanceLadder ladder_;
  double run_up_;
  std::vector<Portal> portals_;
  std::vector<Vec2> anchors_;
  RoomGraph graph_;
  UnionFind components_;
};

}  // namespace

RoomGraph build_room_graph(const Building& building, RoomIndex room, const FreeSpace& space,
                           const RouterConfig& config) {
  return Builder(building, room, space, config).build();
}

}  // namespace echoway::routing
