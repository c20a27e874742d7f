#include "echoway/acoustics/range_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echoway {
namespace {

// Sound grazes past what it ends on: an obstacle nearer than this to the target is the target's own neighbour, metres.
constexpr double kContact = 1e-6;
// Widens conservative bounds by more than rounding can shift them; metres, or directions of a grid.
constexpr double kSlack = 1e-9;

// Plain roots: lengths here are those of rooms, and hypot()'s care for overflow takes longer than all the rest.
double length_of(Vec2 v) noexcept { return std::sqrt(squared_norm(v)); }

void keep_nearest(double range, ElementKind kind, std::int32_t index, PredictedEcho& best) noexcept {
  if (best.kind == ElementKind::none || range < best.range_m) best = {range, kind, index};
}

bool beaten(double range, const PredictedEcho& best) noexcept {
  return best.kind != ElementKind::none && best.range_m <= range;
}

// Whether `wall` crosses the open path from `from` to `to`. Touching the wall's end counts as crossing; touching the
// path's own ends does not.
bool crosses(const Segment& wall, Vec2 from, Vec2 to) noexcept {
  const Vec2 path = to - from;
  const double side_a = cross(path, wall.a - from);
  const double side_b = cross(path, wall.b - from);
  if (side_a * side_b > 0.0 || side_a == side_b) return false;
  const double t = cross(wall.a - from, wall.direction()) / (side_b - side_a);
  return t > 0.0 && t < 1.0 && (1.0 - t) * length_of(path) > kContact;
}

bool within(double reach, const Segment& s, Vec2 point) noexcept {
  return squared_norm(nearest_point(s, point) - point) <= reach * reach;
}

// The part [t0, t1] of a segment, seen from a face, that lies within the beam.
struct Clip {
  double t0 = 0.0;
  double t1 = 1.0;

  void keep_positive(double at_a, double at_b) noexcept {
    if (at_a < 0.0 && at_b < 0.0) t1 = -1.0;
    if ((at_a < 0.0) == (at_b < 0.0)) return;
    const double t = at_a / (at_a - at_b);
    if (at_a < 0.0) {
      t0 = std::max(t0, t);
    } else {
      t1 = std::min(t1, t);
    }
  }
  [[nodiscard]] bool empty() const noexcept { return !(t0 <= t1); }
};

// `s` and `c`: sine and cosine of the beam's half-angle.
Clip clip_to_beam(const Segment& segment, Vec2 face, Vec2 unit, double s, double c) noexcept {
  const auto left = [&](Vec2 q) { return s * dot(unit, q - face) - c * cross(unit, q - face); };
  const auto right = [&](Vec2 q) { return s * dot(unit, q - face) + c * cross(unit, q - face); };
  Clip clip;
  clip.keep_positive(left(segment.a), left(segment.b));
  clip.keep_positive(right(segment.a), right(segment.b));
  return clip;
}

Vec2 point_at(const Segment& segment, double t) noexcept { return segment.a + t * segment.direction(); }

}  // namespace

void Directions::reset(double first, int count) {
  first_ = first;
  step_ = kTwoPi / std::max(1, count);
  unit_.resize(static_cast<std::size_t>(std::max(0, count)));
  for (std::size_t k = 0; k < unit_.size(); ++k) unit_[k] = unit_from_angle(first + step_ * static_cast<double>(k));
}

RangeModel::Ray RangeModel::ray(Vec2 axis, Vec2 unit) const noexcept {
  return {axis, axis + belt_.radius_m * unit, unit};
}

bool RangeModel::blocked(Vec2 from, Vec2 to) const noexcept {
  return std::any_of(occluders_.begin(), occluders_.end(), [&](const Segment& s) { return crosses(s, from, to); });
}

bool RangeModel::hidden(const Ray& ray, Vec2 target) const noexcept {
  return blocked(ray.face, target) || (belt_.radius_m > 0.0 && blocked(ray.axis, ray.face));
}

// Whether obstacles leave free, block, or may partly block every path from a face in reach of `target` to it, or, not
// `converging`, to the points of a wall beside it. Those paths lie within `lateral_` of the line from the axis, and
// begin at most `radius` along it.
RangeModel::Sight RangeModel::sight(Vec2 axis, Vec2 target, bool converging) const noexcept {
  if (occluders_.empty()) return Sight::clear;
  const double length = length_of(target - axis);
  if (!(length > kContact)) return Sight::depends;
  const Vec2 forward = (1.0 / length) * (target - axis);
  const double side = lateral_ + kSlack;
  const double end = length - kContact;
  Sight result = Sight::clear;
  for (const Segment& s : occluders_) {
    const Vec2 a{dot(forward, s.a - axis), cross(forward, s.a - axis)};
    const Vec2 b{dot(forward, s.b - axis), cross(forward, s.b - axis)};
    if (std::max(a.x, b.x) <= -kSlack || std::min(a.x, b.x) > end || std::min(a.y, b.y) > side ||
        std::max(a.y, b.y) < -side) {
      continue;
    }
    // What leaves from the target meets no path to it before, unless it passes between axis and face.
    if (converging && within(kContact, s, target) && !within(belt_.radius_m, s, axis)) continue;
    if (std::min(a.y, b.y) < -side && std::max(a.y, b.y) > side) {
      const double slope = (b.x - a.x) / (b.y - a.y);
      const double at_left = a.x + slope * (side - a.y);
      const double at_right = a.x + slope * (-side - a.y);
      if (std::min(at_left, at_right) > belt_.radius_m && std::max(at_left, at_right) < end - kSlack) {
        return Sight::blocked;
      }
      if (std::max(at_left, at_right) < -kSlack || std::min(at_left, at_right) > length) continue;
    }
    result = Sight::depends;
  }
  return result;
}

// The same for every path to any point of `target`: these lie in the hull of the disc of faces and the segment. Never
// says `blocked`.
RangeModel::Sight RangeModel::sight_along(Vec2 axis, const Segment& target) const noexcept {
  const Vec2 along = target.direction();
  const double turn = cross(target.a - axis, target.b - axis) < 0.0 ? -1.0 : 1.0;
  const Vec2 first = turn > 0.0 ? target.a : target.b;
  const Vec2 last = turn > 0.0 ? target.b : target.a;
  const double margin = belt_.radius_m + kSlack;
  // Positive outside the hull, each scaled by the length of its line.
  const auto right_of_first = [&](Vec2 p) { return cross(p - axis, first - axis); };
  const auto left_of_last = [&](Vec2 p) { return cross(last - axis, p - axis); };
  const auto beyond = [&](Vec2 p) { return turn * cross(p - target.a, along); };
  const double right_margin = margin * length_of(first - axis);
  const double left_margin = margin * length_of(last - axis);
  const double far_margin = -kContact * length_of(along);
  if (beyond(axis) > -margin * length_of(along)) return Sight::depends;  // the disc reaches past the segment's line
  for (const Segment& s : occluders_) {
    if (right_of_first(s.a) > right_margin && right_of_first(s.b) > right_margin) continue;
    if (left_of_last(s.a) > left_margin && left_of_last(s.b) > left_margin) continue;
    if (beyond(s.a) > far_margin && beyond(s.b) > far_margin) continue;
    return Sight::depends;
  }
  return Sight::clear;
}

void RangeModel::offer_wall(const Wall& wall, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept {
  const double side = dot(ray.axis - wall.a, wall.normal) > 0.0 ? -1.0 : 1.0;  // of the wall seen from the axis
  const double z = side * dot(wall.a - ray.face, wall.normal);
  if (!in_range(z) || beaten(z, best)) return;
  if (side * dot(ray.unit, wall.normal) < detection_.cos_half_angle(ElementKind::wall, z)) return;
  const double along = dot(ray.face - wall.a, wall.along);
  if (along < 0.0 || along > wall.length) return;
  if (sight == Sight::depends && hidden(ray, wall.a + along * wall.along)) return;
  keep_nearest(z, ElementKind::wall, wall.index, best);
}

void RangeModel::offer_point(Vec2 at, ElementKind kind, std::int32_t index, const Ray& ray, Sight sight,
                             PredictedEcho& best) const noexcept {
  const Vec2 to = at - ray.face;
  const double z = length_of(to);
  if (!in_range(z) || beaten(z, best)) return;
  if (dot(to, ray.unit) < z * detection_.cos_half_angle(kind, z)) return;
  if (sight == Sight::depends && hidden(ray, at)) return;
  keep_nearest(z, kind, index, best);
}

void RangeModel::offer_corner(const Corner& corner, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept {
  const Vec2 out = ray.face - corner.at;
  if (dot(out, corner.arm_a) < 0.0 || dot(out, corner.arm_b) < 0.0) return;
  offer_point(corner.at, ElementKind::corner, corner.index, ray, sight, best);
}

void RangeModel::offer_edge(const Edge& edge, const Ray& ray, Sight sight, PredictedEcho& best) const noexcept {
  offer_point(edge.at, ElementKind::edge, edge.index, ray, sight, best);
}

void RangeModel::offer_reflector(const Reflector& reflector, const Ray& ray, Sight sight,
                                 PredictedEcho& best) const noexcept {
  const Segment& s = reflector.segment;
  if (dot(ray.face - s.a, reflector.outward) < 0.0) return;
  const double nearest = length_of(nearest_point(s, ray.face) - ray.face);
  if (nearest > belt_.max_range_m || beaten(nearest, best)) return;
  const Clip clip = clip_to_beam(s, ray.face, ray.unit, sin_widest_, cos_widest_);
  if (clip.empty()) return;
  const auto offer = [&](double t) {
    const Vec2 point = point_at(s, t);
    const double z = length_of(point - ray.face);
    if (!in_range(z) || beaten(z, best)) return true;
    if (sight == Sight::depends && hidden(ray, point)) return false;
    keep_nearest(z, ElementKind::reflector, reflector.index, best);
    return true;
  };
  if (offer(std::clamp(nearest_parameter(s, ray.face), clip.t0, clip.t1))) return;
  // Its nearest point is hidden. The nearest visible one then lies at the end of the clip or at the rim of a shadow.
  offer(clip.t0);
  offer(clip.t1);
  for (const Segment& obstacle : occluders_) {
    for (const Vec2 rim : {obstacle.a, obstacle.b}) {
      const Vec2 past = rim - ray.face;
      const double across = cross(past, s.direction());
      const double behind = cross(s.a - ray.face, s.direction());  // over `across`: how many times as far as the rim
      if (across == 0.0 || behind / across < 1.0) continue;
      const double t = cross(s.a - ray.face, past) / across;
      const double nudge = kContact / std::max(kContact, s.length());
      for (const double beside : {t - nudge, t + nudge}) {
        if (beside >= clip.t0 && beside <= clip.t1) offer(beside);
      }
    }
  }
}

PredictedEcho RangeModel::predict(const Pose2& pose, int sensor) const noexcept {
  return predict_towards(pose.position, unit_from_angle(pose.heading + belt_.bearing(sensor)));
}

PredictedEcho RangeModel::predict_towards(Vec2 axis, Vec2 unit) const noexcept {
  const Ray r = ray(axis, unit);
  PredictedEcho best;
  for (const Wall& wall : walls_) offer_wall(wall, r, Sight::depends, best);
  for (const Corner& corner : corners_) offer_corner(corner, r, Sight::depends, best);
  for (const Edge& edge : edges_) offer_edge(edge, r, Sight::depends, best);
  for (const Reflector& reflector : reflectors_) offer_reflector(reflector, r, Sight::depends, best);
  return best;
}

// Calls `offer` for every direction within `half_width` of `bearing`.
template <class Offer>
void RangeModel::for_directions(const Directions& directions, double bearing, double half_width,
                                std::span<PredictedEcho> out, Vec2 axis, Offer offer) const noexcept {
  const int count = directions.count();
  const double middle = (bearing - directions.first()) / directions.step();
  constexpr double kTellable = 1e9;  // Beyond it, and of what is no number, no direction can be told from the next.
  if (!(std::abs(middle) < kTellable)) return;
  const double reach = std::min(half_width / directions.step(), 0.5 * count) + kSlack;
  const double low = std::ceil(middle - reach);
  const int entries = std::min(count, static_cast<int>(std::floor(middle + reach) - low) + 1);
  int k = static_cast<int>(low - count * std::floor(low / count));
  if (k >= count) k -= count;
  for (int i = 0; i < entries; ++i) {
    offer(ray(axis, directions.unit(k)), out[static_cast<std::size_t>(k)]);
    if (++k == count) k = 0;
  }
}

void RangeModel::sweep(Vec2 axis, const Directions& directions, std::span<PredictedEcho> out) const noexcept {
  std::fill(out.begin(), out.end(), PredictedEcho{});
  if (directions.count() == 0) return;
  const double widest = detection_.widest();
  const double reach = belt_.max_range_m + belt_.radius_m;
  const double edge_reach = std::min(reach, edge_reach_ + belt_.radius_m);

  for (const Wall& wall : walls_) {
    const double height = dot(wall.a - axis, wall.normal);
    const double along = dot(axis - wall.a, wall.along);
    if (std::abs(height) > reach || along < -lateral_ - kSlack || along > wall.length + lateral_ + kSlack) continue;
    const Sight seen = sight(axis, axis + height * wall.normal, false);
    if (seen == Sight::blocked) continue;
    const double bearing = height < 0.0 ? wall.normal_angle + kPi : wall.normal_angle;
    for_directions(directions, bearing, widest, out, axis,
                   [&](const Ray& r, PredictedEcho& best) { offer_wall(wall, r, seen, best); });
  }
  const auto each_point = [&](Vec2 at, double farthest, auto offer) {
    const Vec2 to = at - axis;
    if (squared_norm(to) > farthest * farthest) return;
    const Sight seen = sight(axis, at, true);
    if (seen == Sight::blocked) return;
    for_directions(directions, std::atan2(to.y, to.x), widest, out, axis,
                   [&](const Ray& r, PredictedEcho& best) { offer(r, seen, best); });
  };
  for (const Corner& corner : corners_) {
    const Vec2 out_of = axis - corner.at;
    if (dot(out_of, corner.arm_a) < -belt_.radius_m || dot(out_of, corner.arm_b) < -belt_.radius_m) continue;
    each_point(corner.at, reach, [&](const Ray& r, Sight s, PredictedEcho& best) { offer_corner(corner, r, s, best); });
  }
  for (const Edge& edge : edges_) {
    each_point(edge.at, edge_reach, [&](const Ray& r, Sight s, PredictedEcho& best) { offer_edge(edge, r, s, best); });
  }
  sweep_reflectors(axis, directions, reach, out);
}

// Nearest first: what stands farther off is then mostly beaten before it is looked for behind obstacles.
void RangeModel::sweep_reflectors(Vec2 axis, const Directions& directions, double reach,
                                  std::span<PredictedEcho> out) const noexcept {
  struct Ranked {
    double distance;
    const Reflector* reflector;
  };
  std::array<Ranked, 32> ranked;
  for (std::size_t from = 0; from < reflectors_.size(); from += ranked.size()) {
    std::size_t count = 0;
    for (std::size_t i = from; i < std::min(reflectors_.size(), from + ranked.size()); ++i) {
      const double d = length_of(nearest_point(reflectors_[i].segment, axis) - axis);
      if (d <= reach) ranked[count++] = {d, &reflectors_[i]};
    }
    std::sort(ranked.begin(), ranked.begin() + count, [](Ranked a, Ranked b) { return a.distance < b.distance; });
    for (std::size_t i = 0; i < count; ++i) {
      const Reflector& reflector = *ranked[i].reflector;
      const Vec2 a = reflector.segment.a - axis;
      const double turn = [&] {
        const Vec2 b = reflector.segment.b - axis;
        return std::atan2(cross(a, b), dot(a, b));
      }();
      const Sight seen = sight_along(axis, reflector.segment);
      const double half_width = std::abs(turn) > kPi - 1e-6 ? kPi : 0.5 * std::abs(turn) + detection_.widest();
      for_directions(directions, std::atan2(a.y, a.x) + 0.5 * turn, half_width, out, axis,
                     [&](const Ray& r, PredictedEcho& best) { offer_reflector(reflector, r, seen, best); });
    }
  }
}

}  // namespace echoway
