#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "echoway/result.hpp"
#include "echoway/routing/free_space.hpp"
#include "echoway/routing/route.hpp"

namespace echoway {

/// Costs to one goal from every node of a router's graph. Made once a goal; then a way from anywhere takes
/// microseconds.
struct RouteTree {
  struct Target {
    Goal goal{};
    Spot spot{};  ///< Where a walker stands who has arrived.
  };
  Goal goal{};
  RoutePreferences preferences{};
  std::vector<Target> targets;
  std::vector<double> cost;        ///< By node; infinity where nothing leads to the goal.
  std::vector<std::int32_t> next;  ///< By node: the next node, or -1 - i for targets[i].
  /// By node: itself or the first after it that is a door or the end of a link; -1: none.
  std::vector<std::int32_t> way_out;
};

/// Finds shortest safe ways in a building: inside the free space at the walker's half-width (see FreeSpace), through
/// the centres of doors, over stairs and elevators. Exact on polygons but for the arcs about corners: never longer than
/// the shortest way of a walker 8.3 % broader. Where the preferred clearance cannot be had it falls back, step by step,
/// to RouterConfig's last one.
///
/// REQUIRES: the building outlives the router and does not change. Immutable after construction.
class Router {
 public:
  explicit Router(const Building& building, const RouterConfig& config = {});

  [[nodiscard]] const Building& building() const noexcept { return *building_; }
  [[nodiscard]] const RouterConfig& config() const noexcept { return config_; }
  [[nodiscard]] const FreeSpace& space(RoomIndex room) const { return spaces_[static_cast<std::size_t>(room)]; }
  [[nodiscard]] std::size_t node_count() const noexcept { return nodes_.size(); }

  /// A goal by what a wearer would say: the name of a place, an exit or a room, a room's id, or "exit" for the nearest.
  /// Case does not matter. Fails with the names that there are.
  [[nodiscard]] Result<Goal> find_goal(std::string_view text) const;

  /// The costs to `goal` from everywhere. Fails when the goal does not exist or the building has none of its kind.
  [[nodiscard]] Result<RouteTree> tree_to(const Goal& goal, RoutePreferences preferences = {}) const;

  /// Whether anybody can be led to the goal of `tree`: from another room, or from within for who stands in `here`
  /// (kNoRoom: nobody knows) or in a building of one room. Fails, naming the room and the doors that close it, when
  /// nobody can.
  [[nodiscard]] Status check_goal(const RouteTree& tree, RoomIndex here = kNoRoom) const;

  /// Whether a way leads along `tree` from `at` in `room`, or from anywhere in it when that is not known. Fails, naming
  /// the rooms and what is between them, when none does. REQUIRES: the building has the room.
  [[nodiscard]] Status check_way(RoomIndex room, std::optional<Vec2> at, const RouteTree& tree) const;

  /// The way from `from` along `tree` into `route`, whose buffers are reused. Fails, leaving `route` empty, when no
  /// safe way leads there. A start inside a wall is taken for the free point beside it.
  Status route_from(const Spot& from, const RouteTree& tree, Route& route, const BoundFor& bound_for = {}) const;

  /// tree_to() and route_from() in one.
  [[nodiscard]] Result<Route> find_route(const Spot& from, const Goal& goal, RoutePreferences preferences = {}) const;

  /// Back along `crumbs` (oldest first) to the oldest one: loops are cut off and stretches straightened, but only by
  /// ways as safe as a route's.
  [[nodiscard]] Result<Route> retrace(const Spot& from, std::span<const Spot> crumbs) const;

 private:
  struct Node {
    RoomIndex room = kNoRoom;
    Vec2 at{};
    double radius = 0.0;  ///< Clearance that ways to this node keep.
    WaypointKind kind = WaypointKind::turn;
    std::int32_t index = -1;
  };
  struct Edge {
    std::int32_t to = 0;
    float clearance = 0.0F;
    double cost = 0.0;
    bool stairs = false;
  };
  struct Connection {
    std::int32_t node = -1;
    double cost = 0.0;
    double clearance = 0.0;
  };

  void add_rooms();
  void add_doors_and_links();
  void index_edges();
  void add_edge(std::int32_t a, std::int32_t b, double cost, double clearance, bool stairs = false);
  [[nodiscard]] Waypoint through_door(std::int32_t door, RoomIndex from) const;
  [[nodiscard]] double link_cost(const LevelLink& link) const noexcept;
  [[nodiscard]] std::vector<RouteTree::Target> targets_of(const Goal& goal) const;
  [[nodiscard]] Spot stand(const Spot& spot) const;
  [[nodiscard]] bool leads_out(std::int32_t node) const;
  [[nodiscard]] bool is_joined(RoomIndex room) const;
  [[nodiscard]] bool may_lead(RoomIndex room, const RouteTree& tree) const;
  void seed_tree(RouteTree& tree) const;
  void grow_tree(RouteTree& tree) const;
  [[nodiscard]] Connection connect(const Spot& start, const RouteTree& tree, const BoundFor& bound_for) const;
  [[nodiscard]] bool reaches(const Spot& start, std::int32_t node, double radius) const;
  [[nodiscard]] Connection connect_directly(const Spot& start, const RouteTree& tree) const;
  void follow(const Spot& start, const RouteTree& tree, const Connection& first, Route& route) const;
  void append(const Waypoint& waypoint, Route& route) const;

  const Building* building_;
  RouterConfig config_;
  std::vector<FreeSpace> spaces_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> room_begin_;   ///< Nodes of room r: [room_begin_[r], room_begin_[r + 1]).
  std::vector<std::int32_t> door_node_;    ///< By door.
  std::vector<std::array<Vec2, 2>> door_centre_;  ///< By door: its centre on the wall of room a and of room b.
  std::vector<std::int32_t> link_node_;    ///< By link: end a; end b follows it.
  std::vector<std::pair<std::int32_t, Edge>> pending_;  ///< Edges by their tail, until index_edges().
  std::vector<std::int32_t> edge_begin_;
  std::vector<Edge> edges_;
};

}  // namespace echoway
