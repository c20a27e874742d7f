#include "routing/corners.hpp"

#include <algorithm>
#include <cmath>

#include "echoway/geometry/pose2.hpp"

namespace echoway::routing {
namespace {

/// Ends this close together are one corner, metres.
constexpr double kJoint = 0.005;
/// Largest piece of an arc that one turning point stands for.
constexpr double kPiece = kPi / 4.0;
/// A bend flatter than this is no corner.
constexpr double kFlat = 0.01;

/// A solid leaves a corner in this direction.
struct Arm {
  Vec2 corner{};
  double angle = 0.0;
};

std::vector<Arm> collect_arms(std::span<const Segment> solids) {
  std::vector<Arm> arms;
  for (const Segment& s : solids) {
    if (!(s.length() > 0.0)) continue;
    const Vec2 d = s.direction();
    arms.push_back({s.a, std::atan2(d.y, d.x)});
    arms.push_back({s.b, std::atan2(-d.y, -d.x)});
  }
  std::sort(arms.begin(), arms.end(), [](const Arm& s, const Arm& t) {
    return s.corner.x != t.corner.x ? s.corner.x < t.corner.x : s.corner.y < t.corner.y;
  });
  return arms;
}

/// A T-joint: a solid that passes through `corner` leaves it both ways.
void add_through(std::span<const Segment> solids, Vec2 corner, std::vector<double>& angles) {
  for (const Segment& s : solids) {
    if (distance(s, corner) > kJoint || distance(s.a, corner) <= kJoint || distance(s.b, corner) <= kJoint) continue;
    const Vec2 d = s.direction();
    angles.push_back(std::atan2(d.y, d.x));
    angles.push_back(std::atan2(-d.y, -d.x));
  }
}

void add_arc(Vec2 corner, double from, double sweep, double radius, std::vector<TurningPoint>& points) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / kPiece - 1e-9)));
  const double piece = sweep / pieces;
  const double out = radius / std::cos(0.5 * piece);
  for (int i = 0; i < pieces; ++i) {
    const double middle = from + (i + 0.5) * piece;
    const Vec2 clockwise = unit_from_angle(middle - 0.5 * piece - 0.5 * kPi);
    const Vec2 counter = unit_from_angle(middle + 0.5 * piece + 0.5 * kPi);
    points.push_back({corner + out * unit_from_angle(middle), {clockwise, counter}});
  }
}

}  // namespace

std::vector<TurningPoint> turning_points(std::span<const Segment> solids, double radius) {
  const std::vector<Arm> arms = collect_arms(solids);
  std::vector<TurningPoint> points;
  std::vector<bool> taken(arms.size(), false);
  std::vector<double> angles;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    if (taken[i]) continue;
    const Vec2 corner = arms[i].corner;
    angles.clear();
    for (std::size_t j = i; j < arms.size() && arms[j].corner.x <= corner.x + kJoint; ++j) {
      if (taken[j] || distance(arms[j].corner, corner) > kJoint) continue;
      taken[j] = true;
      angles.push_back(arms[j].angle);
    }
    add_through(solids, corner, angles);
    std::sort(angles.begin(), angles.end());
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const bool last = k + 1 == angles.size();
      const double gap = last ? angles.front() + kTwoPi - angles[k] : angles[k + 1] - angles[k];
      if (gap > kPi + kFlat) add_arc(corner, angles[k] + 0.5 * kPi, gap - kPi, radius, points);
    }
  }
  return points;
}

bool is_taut(const std::array<Vec2, 2>& sides, Vec2 direction) noexcept {
  constexpr double kTolerance = 1e-9;
  const double slack = kTolerance * norm(direction);
  const double first = cross(direction, sides[0]);
  const double second = cross(direction, sides[1]);
  return (first <= slack && second <= slack) || (first >= -slack && second >= -slack);
}

}  // namespace echoway::routing
