#include "guidance/hindrances.hpp"

#include <algorithm>
#include <array>
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
  forget_way();
}

bool Hindrances::counts(const Point& point, RoomIndex room, double time_s) noexcept {
  return point.room == room && time_s - point.seen_s <= (point.met > 0 ? kTouchLasts : kRemembered);
}

void Hindrances::add(const Point& point) noexcept {
  Point* oldest = nullptr;
  for (std::size_t i = 0; i < size_; ++i) {
    Point& known = points_[i];
    if (known.room == point.room && distance(known.at, point.at) < kSame) {
      known.at = known.at + 0.3 * (point.at - known.at);
      known.seen_s = point.seen_s;
      known.met = std::max(known.met, point.met);
      return;
    }
    if (oldest == nullptr || known.seen_s < oldest->seen_s) oldest = &known;
  }
  if (size_ < kMost) oldest = &points_[size_++];
  *oldest = point;
}

void Hindrances::add_broad(RoomIndex room, Vec2 at, Vec2 forward, double time_s, int met) noexcept {
  const Vec2 across = perpendicular(forward);
  for (const double side : {0.0, -kTouchBreadth, kTouchBreadth}) add({room, at + side * across, time_s, met});
}

void Hindrances::touch(RoomIndex room, const Pose2& pose, double ahead, double time_s) noexcept {
  const Vec2 forward = unit_from_angle(pose.heading);
  const Vec2 at = pose.position + ahead * forward;
  add_broad(room, at, forward, time_s, 1 + times_met(room, at, time_s));
  forget_way();  // It led here.
}

void Hindrances::stand_before(RoomIndex room, const Pose2& pose, double ahead, double time_s) noexcept {
  const Vec2 forward = unit_from_angle(pose.heading);
  add_broad(room, pose.position + ahead * forward, forward, time_s, 1);
  forget_way();
}

/// How often the wearer has been stopped about there.
int Hindrances::times_met(RoomIndex room, Vec2 at, double time_s) const noexcept {
  constexpr double kAbout = 0.25;  // metres
  int most = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (counts(points_[i], room, time_s) && distance(points_[i].at, at) < kAbout) most = std::max(most, points_[i].met);
  }
  return most;
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
  return std::any_of(near_.begin(), near_.end(), [&](const ThingPoint& thing) {
    const double apart = distance(way, thing.at);
    // Whoever stands too near already may go away from it.
    return apart < radius && apart < distance(way.a, thing.at) - 1e-6;
  });
}

bool Hindrances::stands_near(std::span<const LinePoint> line, std::size_t last) const noexcept {
  for (std::size_t i = 1; i <= last; ++i) {
    const Segment leg{line[i - 1].at, line[i].at};
    const auto matters = [&](const ThingPoint& thing) { return distance(leg, thing.at) < kMatters; };
    if (std::any_of(near_.begin(), near_.end(), matters)) return true;
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

void Hindrances::look_round(RoomIndex room, double time_s, Vec2 from) {
  near_.clear();
  kept_m_ = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    const Point& point = points_[i];
    if (!counts(point, room, time_s) || distance(point.at, from) >= Detour::kReach) continue;
    near_.push_back({point.at, std::max(1, point.met)});
  }
}

bool Hindrances::is_taken(Vec2 at) const {
  return std::any_of(near_.begin(), near_.end(), [&](const ThingPoint& t) { return distance(at, t.at) < kMatters; });
}

/// The farthest place on `leg`, which ends too far away to be searched for, that is near enough to `from` and where no
/// thing is. Where there is none, its beginning, or a metre on from there if that is where the wearer stands.
Vec2 Hindrances::part_of_the_way(Vec2 from, const Segment& leg) const {
  constexpr double kStep = 0.2;
  constexpr double kFar = 0.9 * Detour::kReach;
  const Vec2 unit = (1.0 / distance(leg.a, leg.b)) * (leg.b - leg.a);
  const double least = leg.a == from ? 1.0 : 0.0;
  double on = kFar;
  while (on > least && (distance(from, leg.a + on * unit) > kFar + 1e-6 || is_taken(leg.a + on * unit))) on -= kStep;
  return leg.a + std::max(on, least) * unit;
}

/// How near the way that is kept comes to things, the wearer's own place left out.
double Hindrances::nearest_to_way() const {
  double nearest = kMatters;
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    const Segment leg{kept_[i - 1], kept_[i]};
    for (const ThingPoint& thing : near_) {
      const double apart = distance(leg, thing.at);
      if (apart < distance(kept_.front(), thing.at) - 1e-6) nearest = std::min(nearest, apart);
    }
  }
  return nearest;
}

void Hindrances::bend(const FreeSpace& space, RoomIndex room, double time_s, std::vector<LinePoint>& line) {
  if (line.empty()) return;
  const Vec2 from = line.front().at;
  look_round(room, time_s, from);
  if (near_.empty() || line.size() < 2) return;
  // To the last corner of the line in this room that is near enough, and on from there as far as can be searched: the
  // corner itself may lie in a thing.
  const auto in_reach = [&](Vec2 at) {
    return std::max(std::abs(at.x - from.x), std::abs(at.y - from.y)) < Detour::kReach;
  };
  const auto goes_on = [&](std::size_t i) {
    return i + 1 < line.size() && (i == 0 || line[i].kind == WaypointKind::turn);
  };
  std::size_t last = 0;
  while (goes_on(last) && in_reach(line[last + 1].at)) ++last;
  const bool whole = !goes_on(last);
  const std::size_t next = whole ? last : last + 1;  // from which on the line stays as it is
  if (!stands_near(line, next)) return;
  const Vec2 to = whole ? line[last].at : part_of_the_way(from, {line[last].at, line[next].at});
  if (!detour_.find(space, room, near_, from, to, found_)) {
    near_.clear();
    return;
  }
  if (room != room_ || !still_good(from, to)) kept_ = found_;
  room_ = room;
  kept_m_ = std::max(0.0, nearest_to_way() - kPlay);
  bent_.clear();
  bent_.push_back(line.front());
  for (std::size_t i = 1; i + 1 < kept_.size(); ++i) bent_.push_back({kept_[i], WaypointKind::turn, -1});
  if (!whole) bent_.push_back({to, WaypointKind::turn, -1});
  bent_.insert(bent_.end(), line.begin() + static_cast<std::ptrdiff_t>(next), line.end());
  line.swap(bent_);
}

}  // namespace echoway::guidance
