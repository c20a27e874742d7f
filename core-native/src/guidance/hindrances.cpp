#include "guidance/hindrances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace echoway::guidance {
namespace {

constexpr double kSame = 0.3;         ///< Seen this near a known one, it is that one, metres.
constexpr double kRemembered = 45.0;  ///< Things are moved, and positions err, s.
constexpr double kFurthest = 8.0;     ///< Further on nothing needs be done yet, metres.
constexpr double kPlay = 0.05;        ///< The ring lies this far outside of what must be kept clear, metres.
/// Nobody knows how large a thing is: it is taken for broad while there is room to pass.
constexpr std::array<double, 4> kRadii{0.55, 0.35, 0.2, 0.08};

}  // namespace

Hindrances::Hindrances(const GuideConfig& config) : config_(&config) {
  constexpr std::size_t kLine = 64;  // corners of a way in one room; more grow the memory once
  constexpr std::size_t kNodes = kLine + kMost * kRing;
  near_.reserve(kMost);
  nodes_.reserve(kNodes);
  costs_.reserve(kNodes);
  before_.reserve(kNodes);
  done_.reserve(kNodes);
  bent_.reserve(2 * kNodes);
}

bool Hindrances::counts(const Disc& disc, RoomIndex room, double time_s) const noexcept {
  return disc.room == room && time_s - disc.seen_s <= kRemembered;
}

void Hindrances::add(RoomIndex room, Vec2 at, double time_s) noexcept {
  Disc* oldest = nullptr;
  for (std::size_t i = 0; i < size_; ++i) {
    if (discs_[i].room == room && distance(discs_[i].at, at) < kSame) {
      discs_[i].seen_s = time_s;
      return;
    }
    if (oldest == nullptr || discs_[i].seen_s < oldest->seen_s) oldest = &discs_[i];
  }
  if (size_ < kMost) oldest = &discs_[size_++];
  *oldest = {room, at, time_s};
}

double Hindrances::reach(RoomIndex room, double time_s, Vec2 from, Vec2 unit, double limit) const noexcept {
  double free = limit;
  for (std::size_t i = 0; i < size_; ++i) {
    if (!counts(discs_[i], room, time_s)) continue;
    const Vec2 to = discs_[i].at - from;
    const double along = dot(to, unit);
    if (along <= 0.0 || std::abs(cross(unit, to)) > config_->body_m) continue;
    free = std::min(free, along);
  }
  return free;
}

bool Hindrances::stands_on(const Segment& way, double radius) const noexcept {
  return std::any_of(near_.begin(), near_.end(), [&](Vec2 at) {
    const double apart = distance(way, at);
    // Whoever stands too near already may go away from it.
    return apart < radius && apart < distance(way.a, at) - 1e-6;
  });
}

void Hindrances::bend(const FreeSpace& space, RoomIndex room, double time_s, std::vector<LinePoint>& line) {
  near_.clear();
  if (size_ == 0 || line.size() < 2) return;
  for (std::size_t i = 0; i < size_; ++i) {
    const bool near = counts(discs_[i], room, time_s) && distance(discs_[i].at, line.front().at) < kFurthest;
    if (near) near_.push_back(discs_[i].at);
  }
  if (near_.empty()) return;
  std::size_t last = 1;
  while (last + 1 < line.size() && line[last].kind == WaypointKind::turn) ++last;
  for (const double radius : kRadii) {
    const double needed = radius + config_->body_m;
    bool hindered = false;
    for (std::size_t i = 1; i <= last; ++i) hindered = hindered || stands_on({line[i - 1].at, line[i].at}, needed);
    kept_m_ = needed;
    if (!hindered || lead_round(space, needed, last, line)) return;
  }
  near_.clear();  // there is no way round: it has to be felt for
}

/// The shortest way over the corners of polygons about the discs and the line's own corners (Dijkstra; few nodes).
bool Hindrances::lead_round(const FreeSpace& space, double radius, std::size_t last, std::vector<LinePoint>& line) {
  nodes_.clear();
  for (std::size_t i = 0; i <= last; ++i) nodes_.push_back(line[i].at);
  const double ring = (radius + kPlay) / std::cos(kPi / kRing);
  for (const Vec2 at : near_) {
    for (std::size_t k = 0; k < kRing; ++k) {
      const Vec2 corner = at + ring * unit_from_angle(kTwoPi * static_cast<double>(k) / kRing);
      if (space.contains(corner) && space.clearance(corner, config_->body_m) >= config_->body_m) nodes_.push_back(corner);
    }
  }
  constexpr double kNever = std::numeric_limits<double>::infinity();
  costs_.assign(nodes_.size(), kNever);
  before_.assign(nodes_.size(), 0);
  done_.assign(nodes_.size(), false);
  costs_[0] = 0.0;
  const auto passable = [&](std::size_t from, std::size_t to) {
    if (stands_on({nodes_[from], nodes_[to]}, radius)) return false;
    if (to != last || line[last].kind != WaypointKind::door) {
      return space.clear_between(nodes_[from], nodes_[to], config_->body_m);
    }
    return std::any_of(space.passages().begin(), space.passages().end(), [&](const Passage& p) {
      return p.door == line[last].index && space.clear_to_door(nodes_[from], p, config_->body_m);
    });
  };
  while (true) {
    std::size_t here = nodes_.size();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!done_[i] && costs_[i] < kNever && (here == nodes_.size() || costs_[i] < costs_[here])) here = i;
    }
    if (here == nodes_.size()) return false;
    if (here == last) break;
    done_[here] = true;
    for (std::size_t to = 0; to < nodes_.size(); ++to) {
      const double cost = costs_[here] + distance(nodes_[here], nodes_[to]);
      if (done_[to] || cost >= costs_[to] || !passable(here, to)) continue;
      costs_[to] = cost;
      before_[to] = here;
    }
  }
  bent_.clear();
  for (std::size_t i = before_[last]; i != 0; i = before_[i]) bent_.push_back({nodes_[i], WaypointKind::turn, -1});
  bent_.push_back(line.front());
  std::reverse(bent_.begin(), bent_.end());
  bent_.insert(bent_.end(), line.begin() + static_cast<std::ptrdiff_t>(last), line.end());
  line.swap(bent_);
  return true;
}

}  // namespace echoway::guidance
