#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "echoway/routing/free_space.hpp"
#include "echoway/routing/route.hpp"

namespace echoway::routing {

enum class PortalKind : std::uint8_t { none, door, link_a, link_b };

/// A node of a room's visibility graph: a turn about a convex corner, or the place from which to take a door or stairs.
struct RoomNode {
  Vec2 position{};
  std::int8_t step = 0;                   ///< Index into the ladder: the clearance it keeps.
  PortalKind portal = PortalKind::none;
  std::int32_t portal_index = -1;         ///< Into Building::doors or Building::links.
  Vec2 portal_at{};                       ///< The door's or stairs' own point, in the room's frame.
  std::array<Vec2, 2> sides{};            ///< Corners only: directions along the inflated obstacle, both ways.
};

struct RoomEdge {
  std::int32_t from = 0;
  std::int32_t to = 0;
  double length = 0.0;
  double cost = 0.0;
  double clearance = 0.0;
};

/// The visibility graph of one room for a disc-shaped walker. Obstacles are inflated by the disc; arcs about their
/// convex corners are replaced by circumscribed polygons with pieces of at most 45 degrees, so a way is never longer
/// than the shortest of a disc 8.3 % larger (1/cos 22.5 degrees); everything else is exact. (Lozano-Perez and Wesley
/// 1979; de Berg et al., Computational Geometry, chapter 15.)
struct RoomGraph {
  std::vector<RoomNode> nodes;
  std::vector<RoomEdge> edges;  ///< Undirected, each once.
};

/// Builds the graph with the widest clearance, and with the narrower ones too while its doors, stairs and `anchors`
/// (places that people want to reach) do not all hang together.
[[nodiscard]] RoomGraph build_room_graph(const Building& building, RoomIndex room, const FreeSpace& space,
                                         const RouterConfig& config);

}  // namespace echoway::routing
