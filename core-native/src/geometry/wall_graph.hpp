#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/floor_tracing.hpp"

namespace echoway {

/// The planar graph of a room's walls. Half-edges 2e and 2e + 1 run along edge e, forth and back.
struct WallGraph {
  using Index = std::uint32_t;

  struct Edge {
    Index from = 0;
    Index to = 0;
    Index wall = 0;  ///< One of the walls that run here.
  };

  std::vector<Vec2> vertices;
  std::vector<Edge> edges;
  std::vector<SnappedEnd> snapped;
  bool tangled = false;  ///< Walls cross each other thousands of times: no drawing of a room; the graph is incomplete.

  [[nodiscard]] Index origin(Index half) const { return (half & 1U) != 0 ? edges[half / 2].to : edges[half / 2].from; }
  [[nodiscard]] Index target(Index half) const { return origin(half ^ 1U); }
};

/// REQUIRES: finite walls, each longer than kSamePoint.
[[nodiscard]] WallGraph build_wall_graph(std::span<const Segment> walls);

/// Closed walks along half-edges, each with its face on the left: a bounded face counter-clockwise, the outside of a
/// connected piece clockwise.
struct FaceWalks {
  static constexpr WallGraph::Index kNone = ~WallGraph::Index{0};
  std::vector<std::vector<WallGraph::Index>> walks;
  std::vector<WallGraph::Index> walk_of;  ///< By half-edge; kNone for edges left out.
};

/// Walks along the edges for which `use` is true.
[[nodiscard]] FaceWalks walk_faces(const WallGraph& graph, const std::vector<bool>& use);

}  // namespace echoway
