#include "geometry/floor_tracing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "echoway/geometry/inclusion.hpp"
#include "geometry/wall_graph.hpp"

namespace echoway {
namespace {

using Index = WallGraph::Index;

/// A face smaller than this is a crack between walls, square metres.
constexpr double kSmallestFloor = 0.01;

/// Share of the outer loop's length that walls outside every face may have (see trace_floor()).
constexpr double kStrayShare = 0.25;

struct Loop {
  std::vector<Vec2> points;
  std::vector<Index> halves;
  double area = 0.0;
  Index component = 0;
};

/// Connected pieces of the graph without its screens.
std::vector<Index> components(const WallGraph& graph, const std::vector<bool>& use) {
  std::vector<Index> parent(graph.vertices.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto find = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (use[e]) parent[find(graph.edges[e].from)] = find(graph.edges[e].to);
  }
  for (Index v = 0; v < parent.size(); ++v) parent[v] = find(v);
  return parent;
}

bool inside(const Loop& loop, Vec2 p) { return classify({&loop.points, 1}, p) == Inclusion::inside; }

/// `loop` without the vertices at which it goes straight on.
std::vector<Vec2> without_straight_vertices(const std::vector<Vec2>& loop) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 before = out.empty() ? loop.back() : out.back();
    const Vec2 after = loop[(i + 1) % loop.size()];
    const Vec2 way = after - before;
    const bool straight =
        std::abs(cross(way, loop[i] - before)) <= 1e-7 * norm(way) && dot(loop[i] - before, after - loop[i]) > 0.0;
    if (!straight) out.push_back(loop[i]);
  }
  return out.size() < 3 ? loop : out;
}

class FloorTracer {
 public:
  explicit FloorTracer(std::span<const Segment> walls) : walls_(walls), graph_(build_wall_graph(walls)) {
    if (graph_.tangled) return;
    all_faces_ = walk_faces(graph_, std::vector<bool>(graph_.edges.size(), true));
    bounds_.resize(graph_.edges.size());
    for (std::size_t e = 0; e < bounds_.size(); ++e) {
      bounds_[e] = all_faces_.walk_of[2 * e] != all_faces_.walk_of[2 * e + 1];
    }
  }

  FloorTrace trace() {
    FloorTrace out;
    if (graph_.tangled) return out;
    out.snapped = graph_.snapped;
    find_free_ends(out);
    collect_loops();
    const Loop* floor = largest_loop();
    if (floor == nullptr || stray_length() > kStrayShare * perimeter(*floor)) return out;
    out.closed = true;
    const std::vector<const Loop*> floor_loops = with_holes(*floor);
    for (const Loop* loop : floor_loops) out.boundary.push_back(without_straight_vertices(loop->points));
    find_floor_walks(floor_loops, out.boundary);
    find_meetings(out);
    find_outside_walls(floor->component, out);
    out.cut_off_area = cut_off_area(*floor);
    return out;
  }

 private:
  [[nodiscard]] Vec2 at(Index vertex) const { return graph_.vertices[vertex]; }

  void find_free_ends(FloorTrace& out) const {
    std::vector<int> degree(graph_.vertices.size(), 0);
    for (const WallGraph::Edge& edge : graph_.edges) {
      ++degree[edge.from];
      ++degree[edge.to];
    }
    for (const WallGraph::Edge& edge : graph_.edges) {
      for (const Index vertex : {edge.from, edge.to}) {
        if (degree[vertex] == 1) out.free_ends.push_back({edge.wall, at(vertex)});
      }
    }
    std::sort(out.free_ends.begin(), out.free_ends.end(),
              [](const FreeEnd& a, const FreeEnd& b) { return a.wall < b.wall; });
  }

  void collect_loops() {
    const FaceWalks faces = walk_faces(graph_, bounds_);
    component_ = components(graph_, bounds_);
    for (const std::vector<Index>& walk : faces.walks) {
      Loop& loop = loops_.emplace_back();
      loop.halves = walk;
      loop.component = component_[graph_.origin(walk.front())];
      for (const Index half : walk) loop.points.push_back(at(graph_.origin(half)));
      loop.area = signed_area(loop.points);
    }
  }

  [[nodiscard]] const Loop* largest_loop() const {
    const auto largest =
        std::max_element(loops_.begin(), loops_.end(), [](const Loop& a, const Loop& b) { return a.area < b.area; });
    return largest == loops_.end() || largest->area < kSmallestFloor ? nullptr : &*largest;
  }

  [[nodiscard]] static double perimeter(const Loop& loop) {
    double length = distance(loop.points.back(), loop.points.front());
    for (std::size_t i = 1; i < loop.points.size(); ++i) length += distance(loop.points[i - 1], loop.points[i]);
    return length;
  }

  /// Length of the screens that stand outside every bounded face.
  [[nodiscard]] double stray_length() const {
    double length = 0.0;
    for (std::size_t e = 0; e < bounds_.size(); ++e) {
      if (bounds_[e]) continue;
      const Segment edge{at(graph_.edges[e].from), at(graph_.edges[e].to)};
      const Vec2 middle = 0.5 * (edge.a + edge.b);
      const bool stray = std::none_of(loops_.begin(), loops_.end(),
                                      [&](const Loop& loop) { return loop.area > 0.0 && inside(loop, middle); });
      if (stray) length += edge.length();
    }
    return length;
  }

  /// `floor` and the outlines of what stands on it.
  [[nodiscard]] std::vector<const Loop*> with_holes(const Loop& floor) const {
    std::vector<const Loop*> out{&floor};
    for (const Loop& hole : loops_) {
      if (hole.area < 0.0 && hole.component != floor.component && innermost_around(hole) == &floor)
        out.push_back(&hole);
    }
    return out;
  }

  [[nodiscard]] const Loop* innermost_around(const Loop& hole) const {
    const Loop* innermost = nullptr;
    for (const Loop& loop : loops_) {
      if (loop.area <= 0.0 || loop.component == hole.component || !inside(loop, hole.points.front())) continue;
      if (innermost == nullptr || loop.area < innermost->area) innermost = &loop;
    }
    return innermost;
  }

  /// Marks the walks of the whole graph, screens included, that have the floor on their left.
  void find_floor_walks(const std::vector<const Loop*>& floor_loops, const std::vector<std::vector<Vec2>>& boundary) {
    on_floor_.assign(all_faces_.walks.size(), false);
    for (const Loop* loop : floor_loops) {
      for (const Index half : loop->halves) on_floor_[all_faces_.walk_of[half]] = true;
    }
    for (std::size_t w = 0; w < all_faces_.walks.size(); ++w) {
      const std::vector<Index>& walk = all_faces_.walks[w];
      const bool only_screens = std::none_of(walk.begin(), walk.end(), [&](Index half) { return bounds_[half / 2]; });
      if (only_screens && classify(boundary, at(graph_.origin(walk.front()))) == Inclusion::inside) on_floor_[w] = true;
    }
  }

  void find_meetings(FloorTrace& out) const {
    for (std::size_t w = 0; w < all_faces_.walks.size(); ++w) {
      if (!on_floor_[w]) continue;
      const std::vector<Index>& walk = all_faces_.walks[w];
      for (std::size_t k = 0; k < walk.size(); ++k) {
        const Index arriving = walk[k];
        const Index leaving = walk[(k + 1) % walk.size()];
        const Vec2 corner = at(graph_.target(arriving));
        const Vec2 back = at(graph_.origin(arriving)) - corner;
        const Vec2 on = at(graph_.target(leaving)) - corner;
        double angle = std::atan2(cross(on, back), dot(on, back));
        if (angle <= 0.0 || (arriving ^ 1U) == leaving) angle += kTwoPi;
        out.meetings.push_back({corner, std::min(angle, kTwoPi)});
      }
    }
  }

  void find_outside_walls(Index floor_component, FloorTrace& out) const {
    std::vector<bool> seen(walls_.size(), false);
    std::vector<bool> on_floor(walls_.size(), false);
    for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
      const Index wall = graph_.edges[e].wall;
      seen[wall] = true;
      const bool touches = on_floor_[all_faces_.walk_of[2 * e]] || on_floor_[all_faces_.walk_of[2 * e + 1]];
      if (touches || component_[graph_.edges[e].from] == floor_component) on_floor[wall] = true;
    }
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
      if (seen[wall] && !on_floor[wall]) out.outside_walls.push_back(wall);
    }
  }

  [[nodiscard]] double cut_off_area(const Loop& floor) const {
    double area = 0.0;
    for (const Loop& loop : loops_) {
      if (&loop != &floor && loop.component == floor.component) area = std::max(area, loop.area);
    }
    return area;
  }

  std::span<const Segment> walls_;
  WallGraph graph_;
  FaceWalks all_faces_;
  std::vector<bool> bounds_;  ///< By edge: has different faces on its two sides.
  std::vector<Loop> loops_;
  std::vector<Index> component_;  ///< By vertex: the connected piece of the graph without screens.
  std::vector<bool> on_floor_;    ///< By walk of all_faces_.
};

}  // namespace

FloorTrace trace_floor(std::span<const Segment> walls) { return FloorTracer(walls).trace(); }

double gap_at(std::span<const Segment> walls, const FreeEnd& end) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < walls.size(); ++other) {
    if (other != end.wall) gap = std::min(gap, distance(walls[other], end.at));
  }
  return gap;
}

}  // namespace echoway
