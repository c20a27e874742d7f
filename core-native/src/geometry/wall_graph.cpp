#include "geometry/wall_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace echoway {
namespace {

using Index = WallGraph::Index;

/// Crossings that a room may have before its walls count as a tangle: bounds memory and time on hostile input.
constexpr std::size_t kMaxCrossings = 5000;

struct Box {
  Vec2 low{};
  Vec2 high{};

  explicit Box(const Segment& s)
      : low{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)}, high{std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)} {}

  [[nodiscard]] bool is_within(double reach, Vec2 p) const noexcept {
    return p.x >= low.x - reach && p.x <= high.x + reach && p.y >= low.y - reach && p.y <= high.y + reach;
  }
};

/// A vertex on a wall, `t` metres from the wall's first end.
struct Stop {
  double t = 0.0;
  Index vertex = 0;
};

class GraphBuilder {
 public:
  explicit GraphBuilder(std::span<const Segment> walls)
      : walls_(walls), boxes_(walls.begin(), walls.end()), stops_(walls.size()) {}

  WallGraph build() {
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      add_stop(i, walls_[i].a);
      add_stop(i, walls_[i].b);
    }
    split_where_walls_meet();
    if (graph_.tangled) return std::move(graph_);
    make_edges();
    if (snap_free_ends()) make_edges();
    return std::move(graph_);
  }

 private:
  /// The vertex at `p`, new when there is none within kSamePoint. The grid's cells are as wide as that distance, so
  /// that only the nine around `p` can hold it.
  Index vertex_at(Vec2 p) {
    const auto cell = [](double v) { return static_cast<std::int64_t>(std::floor(v / kSamePoint)); };
    const std::int64_t cx = cell(p.x);
    const std::int64_t cy = cell(p.y);
    for (std::int64_t x = cx - 1; x <= cx + 1; ++x) {
      for (std::int64_t y = cy - 1; y <= cy + 1; ++y) {
        const auto found = grid_.find({x, y});
        if (found != grid_.end() && distance(graph_.vertices[found->second], p) <= kSamePoint) return found->second;
      }
    }
    const auto index = static_cast<Index>(graph_.vertices.size());
    graph_.vertices.push_back(p);
    grid_.emplace(std::pair{cx, cy}, index);
    return index;
  }

  void add_stop(std::size_t wall, Vec2 p) { stops_[wall].push_back({along(wall, p), vertex_at(p)}); }

  [[nodiscard]] double along(std::size_t wall, Vec2 p) const {
    const Segment& s = walls_[wall];
    return dot(p - s.a, s.direction()) / s.length();
  }

  /// Sorted by their left side, each wall is compared with those that start before it ends.
  void split_where_walls_meet() {
    std::vector<std::size_t> order(walls_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto left = [this](std::size_t i) { return boxes_[i].low.x; };
    const auto right = [this](std::size_t i) { return boxes_[i].high.x; };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return std::pair{left(i), i} < std::pair{left(j), j};
    });
    for (std::size_t k = 0; k < order.size() && !graph_.tangled; ++k) {
      for (std::size_t m = k + 1; m < order.size() && left(order[m]) <= right(order[k]) + kSamePoint; ++m) {
        split_pair(order[k], order[m]);
      }
    }
  }

  void split_pair(std::size_t i, std::size_t j) {
    const Segment& p = walls_[i];
    const Segment& q = walls_[j];
    if (boxes_[i].low.y > boxes_[j].high.y + kSamePoint || boxes_[j].low.y > boxes_[i].high.y + kSamePoint) return;
    bool touch = false;
    for (const Vec2 end : {q.a, q.b}) touch |= split_at(i, end);
    for (const Vec2 end : {p.a, p.b}) touch |= split_at(j, end);
    if (touch) return;
    const double denominator = cross(p.direction(), q.direction());
    if (denominator == 0.0) return;
    const double s = cross(q.a - p.a, q.direction()) / denominator;
    const double t = cross(q.a - p.a, p.direction()) / denominator;
    if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) return;
    if (++crossings_ > kMaxCrossings) graph_.tangled = true;
    if (graph_.tangled) return;
    const Vec2 crossing = p.a + s * p.direction();
    add_stop(i, crossing);
    add_stop(j, crossing);
  }

  bool split_at(std::size_t wall, Vec2 end) {
    if (distance(walls_[wall], end) > kSamePoint) return false;
    add_stop(wall, end);
    return true;
  }

  void make_edges() {
    std::vector<WallGraph::Edge>& edges = graph_.edges;
    edges.clear();
    for (std::size_t wall = 0; wall < stops_.size(); ++wall) {
      std::vector<Stop>& stops = stops_[wall];
      std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
        return std::pair{a.t, a.vertex} < std::pair{b.t, b.vertex};
      });
      for (std::size_t k = 1; k < stops.size(); ++k) {
        const auto [low, high] = std::minmax(stops[k - 1].vertex, stops[k].vertex);
        if (low != high) edges.push_back({low, high, static_cast<Index>(wall)});
      }
    }
    // Walls drawn twice, or one over part of another, give the same edge twice.
    const auto key = [](const WallGraph::Edge& e) { return std::pair{e.from, e.to}; };
    std::stable_sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    edges.erase(std::unique(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                edges.end());
  }

  /// Joins free ends to what they nearly touch. True when it changed anything.
  bool snap_free_ends() {
    std::vector<int> degree(graph_.vertices.size(), 0);
    for (const WallGraph::Edge& edge : graph_.edges) {
      ++degree[edge.from];
      ++degree[edge.to];
    }
    bool changed = false;
    for (std::size_t wall = 0; wall < walls_.size(); ++wall) {
      for (const bool first : {true, false}) {
        const Index vertex = first ? stops_[wall].front().vertex : stops_[wall].back().vertex;
        if (degree[vertex] == 1) changed |= snap(wall, vertex, degree);
      }
    }
    return changed;
  }

  bool snap(std::size_t wall, Index vertex, std::vector<int>& degree) {
    const Vec2 from = graph_.vertices[vertex];
    std::optional<std::size_t> nearest;
    double best = kSnapDistance;
    for (std::size_t other = 0; other < walls_.size(); ++other) {
      if (other == wall || !boxes_[other].is_within(kSnapDistance, from)) continue;
      const double d = distance(walls_[other], from);
      if (d <= best && d > 0.0) {
        best = d;
        nearest = other;
      }
    }
    if (!nearest) return false;
    const Index target = target_on(*nearest, from);
    const Vec2 to = graph_.vertices[target];
    for (Stop& stop : stops_[wall]) {
      if (stop.vertex == vertex) stop.vertex = target;
    }
    degree.resize(graph_.vertices.size(), 0);
    degree[vertex] = 0;
    ++degree[target];
    graph_.snapped.push_back({wall, from, distance(from, to)});
    return true;
  }

  /// Where a free end near `wall` goes: to a vertex of it within reach, else to its nearest point.
  Index target_on(std::size_t wall, Vec2 from) {
    const Stop* nearest = nullptr;
    for (const Stop& stop : stops_[wall]) {
      const double d = distance(graph_.vertices[stop.vertex], from);
      if (d <= kSnapDistance && (nearest == nullptr || d < distance(graph_.vertices[nearest->vertex], from))) {
        nearest = &stop;
      }
    }
    if (nearest != nullptr) return nearest->vertex;
    const Vec2 foot = nearest_point(walls_[wall], from);
    add_stop(wall, foot);
    return stops_[wall].back().vertex;
  }

  std::span<const Segment> walls_;
  std::vector<Box> boxes_;
  std::vector<std::vector<Stop>> stops_;
  std::map<std::pair<std::int64_t, std::int64_t>, Index> grid_;
  std::size_t crossings_ = 0;
  WallGraph graph_;
};

}  // namespace

WallGraph build_wall_graph(std::span<const Segment> walls) { return GraphBuilder(walls).build(); }

FaceWalks walk_faces(const WallGraph& graph, const std::vector<bool>& use) {
  const auto half_edges = static_cast<Index>(2 * graph.edges.size());
  std::vector<Index> order;
  std::vector<double> angle(half_edges, 0.0);
  for (Index half = 0; half < half_edges; ++half) {
    if (!use[half / 2]) continue;
    const Vec2 d = graph.vertices[graph.target(half)] - graph.vertices[graph.origin(half)];
    angle[half] = std::atan2(d.y, d.x);
    order.push_back(half);
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::tuple{graph.origin(a), angle[a], a} < std::tuple{graph.origin(b), angle[b], b};
  });
  // Around a vertex, counter-clockwise; the walk arriving by h leaves by the one clockwise next to h's way back, which
  // keeps the face on the left.
  std::vector<Index> next(half_edges, FaceWalks::kNone);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && graph.origin(order[end]) == graph.origin(order[begin])) ++end;
    for (std::size_t k = begin; k < end; ++k) next[order[k] ^ 1U] = order[k == begin ? end - 1 : k - 1];
  }
  FaceWalks faces;
  faces.walk_of.assign(half_edges, FaceWalks::kNone);
  for (const Index start : order) {
    if (faces.walk_of[start] != FaceWalks::kNone) continue;
    const auto walk = static_cast<Index>(faces.walks.size());
    std::vector<Index>& halves = faces.walks.emplace_back();
    for (Index half = start; faces.walk_of[half] == FaceWalks::kNone; half = next[half]) {
      faces.walk_of[half] = walk;
      halves.push_back(half);
    }
  }
  return faces;
}

}  // namespace echoway
