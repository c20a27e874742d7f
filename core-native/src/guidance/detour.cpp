#include "guidance/detour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace echoway::guidance {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Nearer to a wall than this nobody stands, metres.
constexpr double kShoulders = 0.2;
/// Unless they stand there already or are to go there.
constexpr double kEnd = 0.35;

struct Step {
  double within;
  double factor;
};
/// What a metre costs this near to a wall, or to a point of a thing.
constexpr std::array<Step, 3> kByWalls{{{0.25, 3.0}, {0.35, 1.6}, {0.45, 1.2}}};
constexpr std::array<Step, 5> kByThings{{{0.2, 30.0}, {0.3, 8.0}, {0.4, 3.0}, {0.55, 1.6}, {0.8, 1.15}}};
constexpr double kWidest = 0.8;
/// Who passes a point of what stopped them this near, metres, is stopped by it again; from there on there may be a gap
/// beside it.
constexpr double kBody = 0.2;

/// Calls `visit(cell, dx, dy)` for the cells of a square field of `side` that lie at most `around` cells from `middle`.
template <class Visit>
void for_each_near(std::int32_t middle, std::int32_t around, std::int32_t side, Visit visit) {
  for (std::int32_t dy = -around; dy <= around; ++dy) {
    for (std::int32_t dx = -around; dx <= around; ++dx) {
      const std::int32_t x = middle % side + dx;
      const std::int32_t y = middle / side + dy;
      if (x >= 0 && y >= 0 && x < side && y < side) visit(y * side + x, dx, dy);
    }
  }
}

template <std::size_t n>
double factor(const std::array<Step, n>& steps, double apart) noexcept {
  for (const Step& s : steps) {
    if (apart < s.within) return s.factor;
  }
  return 1.0;
}

}  // namespace

Detour::Detour() {
  walls_.reserve(kCells);
  effort_.reserve(kCells);
  costs_.reserve(kCells);
  before_.reserve(kCells);
  open_.reserve(8 * kCells);
  path_.reserve(kCells);
  along_.reserve(kCells);
}

std::int32_t Detour::cell_of(Vec2 p) const noexcept {
  const double x = std::floor((p.x - origin_.x) / kCell);
  const double y = std::floor((p.y - origin_.y) / kCell);
  if (!(x >= 0.0 && y >= 0.0 && x < kSide && y < kSide)) return -1;
  return static_cast<std::int32_t>(y) * kSide + static_cast<std::int32_t>(x);
}

Vec2 Detour::middle_of(std::int32_t cell) const noexcept {
  return origin_ + kCell * Vec2{cell % kSide + 0.5, cell / kSide + 0.5};
}

/// Walls stay: looked at afresh only in another room or once the wearer has gone on by a metre.
void Detour::look_at_walls(const FreeSpace& space, RoomIndex room, Vec2 from) {
  const Vec2 middle = origin_ + 0.5 * kSide * kCell * Vec2{1.0, 1.0};
  const double spare = 0.5 * kSide * kCell - kReach;
  const Vec2 off = from - middle;
  if (room == room_ && std::max(std::abs(off.x), std::abs(off.y)) <= spare) return;
  room_ = room;
  origin_ = from - 0.5 * kSide * kCell * Vec2{1.0, 1.0};
  walls_.assign(kCells, std::numeric_limits<float>::infinity());
  for (std::int32_t i = 0; i < kCells; ++i) {
    const Vec2 p = middle_of(i);
    const double clear = space.clearance(p, 0.5);
    if (clear < kShoulders || !space.contains(p)) continue;
    walls_[static_cast<std::size_t>(i)] = static_cast<float>(factor(kByWalls, clear));
  }
}

void Detour::look_at_things(std::span<const ThingPoint> things) {
  effort_ = walls_;
  constexpr auto kAround = static_cast<std::int32_t>(kWidest / kCell) + 1;
  // The nearest thing counts: the dearest factor of all.
  for (const ThingPoint& thing : things) {
    const std::int32_t middle = cell_of(thing.at);
    if (middle < 0) continue;
    for_each_near(middle, kAround, kSide, [&](std::int32_t near, std::int32_t, std::int32_t) {
      const auto cell = static_cast<std::size_t>(near);
      if (!(walls_[cell] < kNever)) return;
      const double apart = distance(middle_of(near), thing.at);
      const double f = factor(kByThings, apart) * (apart < kBody ? thing.met : 1);
      effort_[cell] = std::max(effort_[cell], static_cast<float>(f * walls_[cell]));
    });
  }
}

/// Whoever stands close to a wall, or is to go through a doorway, may.
void Detour::open_ends(const FreeSpace& space, Vec2 from, Vec2 to) {
  constexpr float kTight = 4.0F;
  constexpr auto kAround = static_cast<std::int32_t>(kEnd / kCell) + 1;
  for (const Vec2 end : {from, to}) {
    const std::int32_t middle = cell_of(end);
    for_each_near(middle, kAround, kSide, [&](std::int32_t near, std::int32_t, std::int32_t) {
      const auto cell = static_cast<std::size_t>(near);
      const Vec2 p = middle_of(near);
      const double apart = distance(p, end);
      if (effort_[cell] < kNever || apart > kEnd) return;
      const auto reaches = [&] { return space.reach(end, (1.0 / apart) * (p - end), kEnd) > apart; };
      if (near == middle || (space.contains(p) && reaches())) effort_[cell] = kTight;
    });
  }
}

bool Detour::search(std::int32_t from, std::int32_t to) {
  const auto later = [](const Open& a, const Open& b) { return a.cost > b.cost; };
  costs_.assign(kCells, kNever);
  before_.assign(kCells, -1);
  open_.clear();
  costs_[static_cast<std::size_t>(from)] = 0.0;
  open_.push_back({0.0, from});
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), later);
    const Open here = open_.back();
    open_.pop_back();
    if (here.cell == to) return true;
    if (here.cost > costs_[static_cast<std::size_t>(here.cell)]) continue;
    const double effort_here = effort_[static_cast<std::size_t>(here.cell)];
    for_each_near(here.cell, 1, kSide, [&](std::int32_t near, std::int32_t dx, std::int32_t dy) {
      const auto next = static_cast<std::size_t>(near);
      const double effort = 0.5 * (static_cast<double>(effort_[next]) + effort_here);
      const double cost = here.cost + effort * kCell * std::sqrt(static_cast<double>(dx * dx + dy * dy));
      if (!(cost < costs_[next])) return;
      costs_[next] = cost;
      before_[next] = here.cell;
      open_.push_back({cost, near});
      std::push_heap(open_.begin(), open_.end(), later);
    });
  }
  return false;
}

double Detour::straight_cost(Vec2 a, Vec2 b) const noexcept {
  const double length = distance(a, b);
  const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * length / kCell)));
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const std::int32_t cell = cell_of(a + ((i + 0.5) / pieces) * (b - a));
    if (cell < 0) return kNever;
    sum += effort_[static_cast<std::size_t>(cell)];
  }
  return sum * length / pieces;
}

double Detour::cost(std::span<const Vec2> way) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += straight_cost(way[i - 1], way[i]);
  return sum;
}

/// Corners only where going straight would cost more. Past a wall's corner, where a step costs without end here, the
/// way is too tight to be told turn by turn: from there it goes straight, by touch.
void Detour::straighten(Vec2 from, Vec2 to, std::vector<Vec2>& way) {
  path_.clear();
  for (std::int32_t cell = cell_of(to); cell >= 0; cell = before_[static_cast<std::size_t>(cell)]) {
    path_.push_back(middle_of(cell));
  }
  std::reverse(path_.begin(), path_.end());
  path_.front() = from;
  path_.back() = to;
  if (path_.size() == 1) path_ = {from, to};
  along_.assign(path_.size(), 0.0);
  for (std::size_t i = 1; i < path_.size(); ++i) along_[i] = along_[i - 1] + straight_cost(path_[i - 1], path_[i]);
  constexpr double kWorthACorner = 1.04;  // besides what the cells' eight directions cost
  way.clear();
  way.push_back(from);
  for (std::size_t here = 0; here + 1 < path_.size();) {
    const auto costs_more_straight = [&](std::size_t there) {
      return straight_cost(path_[here], path_[there]) > kWorthACorner * (along_[there] - along_[here]) + 0.02;
    };
    std::size_t next = path_.size() - 1;
    while (next > here + 1 && costs_more_straight(next)) --next;
    way.push_back(path_[next]);
    here = next;
  }
}

bool Detour::find(const FreeSpace& space, RoomIndex room, std::span<const ThingPoint> things, Vec2 from, Vec2 to,
                  std::vector<Vec2>& way) {
  look_at_walls(space, room, from);
  look_at_things(things);
  if (cell_of(from) < 0 || cell_of(to) < 0) return false;
  open_ends(space, from, to);
  if (!search(cell_of(from), cell_of(to))) return false;
  straighten(from, to, way);
  return true;
}

}  // namespace echoway::guidance
