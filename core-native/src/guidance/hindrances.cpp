#include "guidance/hindrances.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::guidance {
namespace {

constexpr double kSame = 0.12;        ///< Heard this near a known point, it is that one, metres.
constexpr double kRemembered = 60.0;  ///< Things are moved, and positions err, s.
constexpr double kTouchLasts = 180.0; ///< Nobody doubts what was touched, s.
constexpr double kTouchBreadth = 0.14;///< What is touched is at least so broad to either side of the chest, metres.
constexpr double kMatters = 0.6;      ///< Things further from the way than this leave it as it is, metres.
constexpr double kPlay = 0.07;        ///< What a way may come nearer to things than it was laid out, metres.
constexpr double kThere = 0.3;        ///< A corner of the way is passed once it is this near, metres.
constexpr double kMuchBetter = 0.75;  ///< Another way round is taken only if it costs less than this share.

}  // namespace

Hindrances::Hindrances(const GuideConfig& config) : config_(&config) {
  constexpr std::size_t kCorners = 128;
  near_.reserve(kMost);
  kept_.reserve(kCorners);
  found_.reserve(kCorners);
  bent_.reserve(kCorners);
}

void Hindrances::clear() noexcept {
  size_ = 0;
  kept_.clear();
}

bool Hindrances::counts(const Point& point, RoomIndex room, double time_s) noexcept {
  return point.room == room && time_s - point.seen_s <= (point.touched ? kTouchLasts : kRemembered);
}

void Hindrances::add(const Point& point) noexcept {
  Point* oldest = nullptr;
  for (std::size_t i = 0; i < size_; ++i) {
    Point& known = points_[i];
    if (known.room == point.room && distance(known.at, point.at) < kSame) {
      known.at = known.at + 0.3 * (point.at - known.at);
      known.seen_s = point.seen_s;
      known.touched = known.touched || point.touched;
      return;
    }
    if (oldest == nullptr || known.seen_s < oldest->seen_s) oldest = &known;
  }
  if (size_ < kMost) oldest = &points_[size_++];
  *oldest = point;
}

void Hindrances::touch(RoomIndex room, const Pose2& pose, double ahead, double time_s) noexcept {
  const Vec2 forward = unit_from_angle(pose.heading);
  for (const double side : {0.0, -kTouchBreadth, kTouchBreadth}) {
    add({room, pose.position + ahead * forward + side * perpendicular(forward), time_s, true});
  }
  kept_.clear();  // the way that led here was wrong
}

double Hindrances::reach(RoomIndex room, double time_s, Vec2 from, Vec2 unit, double limit) const noexcept {
  double free = limit;
  for (std::size_t i = 0; i < size_; ++i) {
    if (!counts(points_[i], room, time_s)) continue;
    const Vec2 to = points_[i].at - from;
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

bool Hindrances::stands_near(std::span<const LinePoint> line, std::size_t last) const noexcept {
  for (std::size_t i = 1; i <= last; ++i) {
    const Segment leg{line[i - 1].at, line[i].at};
    if (std::any_of(near_.begin(), near_.end(), [&](Vec2 at) { return distance(leg, at) < kMatters; })) return true;
  }
  return false;
}

/// The way found earlier, from where the wearer is now; true while it is little worse than the one just found.
bool Hindrances::still_good(Vec2 from, Vec2 to) {
  if (kept_.size() < 2) return false;
  kept_.front() = from;
  while (kept_.size() > 2 && distance(from, kept_[1]) < kThere) kept_.erase(kept_.begin() + 1);
  // A corner that the wearer has cut or passed by is left out.
  while (kept_.size() > 2) {
    const std::array<Vec2, 2> cut{from, kept_[2]};
    const std::array<Vec2, 3> round{from, kept_[1], kept_[2]};
    if (detour_.cost(cut) > detour_.cost(round) + 0.02) break;
    kept_.erase(kept_.begin() + 1);
  }
  kept_.back() = to;
  const double cost = detour_.cost(kept_);
  return std::isfinite(cost) && kMuchBetter * cost <= detour_.cost(found_);
}

void Hindrances::bend(const FreeSpace& space, RoomIndex room, double time_s, std::vector<LinePoint>& line) {
  near_.clear();
  kept_m_ = 0.0;
  if (size_ == 0 || line.size() < 2) return;
  const Vec2 from = line.front().at;
  for (std::size_t i = 0; i < size_; ++i) {
    if (counts(points_[i], room, time_s) && distance(points_[i].at, from) < Detour::kReach) near_.push_back(points_[i].at);
  }
  if (near_.empty()) return;
  // The last corner of the line that is near enough, in this room; the next one is cut short if there is none.
  std::size_t last = 1;
  const auto in_reach = [&](Vec2 at) { return std::max(std::abs(at.x - from.x), std::abs(at.y - from.y)) < Detour::kReach; };
  while (last + 1 < line.size() && line[last].kind == WaypointKind::turn && in_reach(line[last + 1].at)) ++last;
  if (!stands_near(line, last)) return;
  Vec2 to = line[last].at;
  bool cut = false;
  if (!in_reach(to)) {
    const Vec2 way = to - from;
    const double length = norm(way);
    double on = 0.9 * Detour::kReach;
    // It should not end within a thing.
    const auto taken = [&](double at) {
      return std::any_of(near_.begin(), near_.end(), [&](Vec2 p) { return distance(from + (at / length) * way, p) < kMatters; });
    };
    while (on > 1.0 && taken(on)) on -= 0.2;
    to = from + (on / length) * way;
    cut = true;
  }
  if (!detour_.find(space, room, near_, from, to, found_)) {
    near_.clear();
    return;
  }
  if (room != room_ || !still_good(from, to)) kept_ = found_;
  room_ = room;
  double nearest = kMatters;
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    const Segment leg{kept_[i - 1], kept_[i]};
    for (const Vec2 at : near_) {
      // Where the wearer stands already does not count.
      const double apart = distance(leg, at);
      if (apart < distance(from, at) - 1e-6) nearest = std::min(nearest, apart);
    }
  }
  kept_m_ = std::max(0.0, nearest - kPlay);
  bent_.clear();
  bent_.push_back(line.front());
  for (std::size_t i = 1; i + 1 < kept_.size(); ++i) bent_.push_back({kept_[i], WaypointKind::turn, -1});
  if (cut) bent_.push_back({to, WaypointKind::turn, -1});
  bent_.insert(bent_.end(), line.begin() + static_cast<std::ptrdiff_t>(last), line.end());
  line.swap(bent_);
}

}  // namespace echoway::guidance
