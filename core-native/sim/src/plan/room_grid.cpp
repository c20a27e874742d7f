#include "plan/room_grid.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "echoway/geometry/box.hpp"
#include "echoway/geometry/inclusion.hpp"

namespace echoway::sim {

namespace {

// Benches are drawn as closed outlines of all-reflective elements; nobody stands on one. Even-odd along +x.
bool on_bench(const Room& room, Vec2 p) {
  bool on = false;
  for (const Segment& side : room.reflectors) {
    if ((side.a.y > p.y) == (side.b.y > p.y)) continue;
    if ((cross(side.direction(), p - side.a) > 0.0) == (side.b.y > side.a.y)) on = !on;
  }
  return on;
}

constexpr double kMostCells = 16e6;

}  // namespace

bool RoomGrid::fits(const Room& room) noexcept {
  if (room.walls.empty()) return true;
  const auto [low, high] = box_about(room.walls);
  return ((high.x - low.x) / kCell + 1.0) * ((high.y - low.y) / kCell + 1.0) <= kMostCells;
}

RoomGrid::RoomGrid(const Room& room) {
  if (room.walls.empty()) return;
  const auto [low, high] = box_about(room.walls);
  origin_ = low;
  columns_ = std::max(1, static_cast<int>((high.x - low.x) / kCell) + 1);
  rows_ = std::max(1, static_cast<int>((high.y - low.y) / kCell) + 1);
  clearance_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int cell = 0; cell < static_cast<int>(clearance_.size()); ++cell) {
    const Vec2 p = centre(cell);
    double d = std::numeric_limits<double>::infinity();
    for (const Segment& wall : room.walls) d = std::min(d, distance(wall, p));
    for (const Segment& bench : room.reflectors) d = std::min(d, distance(bench, p));
    clearance_[static_cast<std::size_t>(cell)] = contains(room.boundary, p) && !on_bench(room, p) ? d : -d;
  }
}

int RoomGrid::index(Vec2 p) const noexcept {
  const int column = static_cast<int>((p.x - origin_.x) / kCell);
  const int row = static_cast<int>((p.y - origin_.y) / kCell);
  if (p.x < origin_.x || p.y < origin_.y || column >= columns_ || row >= rows_) return -1;
  return row * columns_ + column;
}

Vec2 RoomGrid::centre(int cell) const noexcept {
  return origin_ + Vec2{(cell % columns_ + 0.5) * kCell, (cell / columns_ + 0.5) * kCell};
}

double RoomGrid::clearance(Vec2 p) const noexcept {
  const int cell = index(p);
  return cell < 0 ? -1.0 : clearance_[static_cast<std::size_t>(cell)];
}

bool RoomGrid::straight(Vec2 a, Vec2 b, double wanted) const noexcept {
  const int samples = static_cast<int>(distance(a, b) / (0.5 * kCell)) + 1;
  for (int i = 0; i <= samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    if (clearance(a + t * (b - a)) < wanted) return false;
  }
  return true;
}

std::vector<Vec2> RoomGrid::path(Vec2 from, Vec2 to) const {
  const double wanted = std::min({kBody, clearance(from), clearance(to)});
  if (wanted <= 0.0) return {};
  if (straight(from, to, wanted)) return {to};

  // A* with a price on closeness to walls, then the string is pulled tight between cells that see each other.
  const int start = index(from);
  const int goal = index(to);
  const std::size_t count = clearance_.size();
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  std::vector<int> came_from(count, -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[static_cast<std::size_t>(start)] = 0.0;
  open.emplace(distance(from, to), start);
  while (!open.empty()) {
    const int cell = open.top().second;
    open.pop();
    if (cell == goal) break;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int column = cell % columns_ + dx;
        const int row = cell / columns_ + dy;
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
        const int next = row * columns_ + column;
        const double room = clearance_[static_cast<std::size_t>(next)];
        if (next == cell || room < wanted) continue;
        const double step = kCell * hypotenuse(dx, dy) * (1.0 + 2.0 * std::max(0.0, kComfort - room) / kComfort);
        const double total = cost[static_cast<std::size_t>(cell)] + step;
        if (total >= cost[static_cast<std::size_t>(next)]) continue;
        cost[static_cast<std::size_t>(next)] = total;
        came_from[static_cast<std::size_t>(next)] = cell;
        open.emplace(total + distance(centre(next), to), next);
      }
    }
  }
  if (came_from[static_cast<std::size_t>(goal)] < 0) return {};
  std::vector<Vec2> cells{to};
  for (int cell = came_from[static_cast<std::size_t>(goal)]; cell != start && cell >= 0;
       cell = came_from[static_cast<std::size_t>(cell)]) {
    cells.push_back(centre(cell));
  }
  std::reverse(cells.begin(), cells.end());
  std::vector<Vec2> pulled;
  Vec2 here = from;
  for (std::size_t i = 0; i < cells.size();) {
    std::size_t far = i;
    while (far + 1 < cells.size() && straight(here, cells[far + 1], wanted)) ++far;
    here = cells[far];
    pulled.push_back(here);
    i = far + 1;
  }
  return pulled;
}

std::optional<Vec2> RoomGrid::random_place(Random& random) const {
  for (const double wanted : {kComfort, kBody + 0.05, 0.15}) {
    std::vector<int> cells;
    for (std::size_t i = 0; i < clearance_.size(); ++i) {
      if (clearance_[i] >= wanted) cells.push_back(static_cast<int>(i));
    }
    if (cells.empty()) continue;
    const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(cells.size()));
    return centre(cells[std::min(pick, cells.size() - 1)]);
  }
  return std::nullopt;
}

}  // namespace echoway::sim
