// Poses, segments, the inclusion test and predicted ranges on geometry that is nearly degenerate.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "echoway/acoustics/range_model.hpp"
#include "echoway/geometry/inclusion.hpp"
#include "echoway/random.hpp"
#include "plans/plans.hpp"
#include "stiff/case.hpp"

namespace echoway::stiff {
namespace {

constexpr double kGrid = 0x1.0p-10;  // metres; coordinates on it are exact, and so is the reference below
using Loops = std::vector<std::vector<Vec2>>;

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

GridPoint on_grid(Vec2 p) {
  return {static_cast<std::int64_t>(std::llround(p.x / kGrid)), static_cast<std::int64_t>(std::llround(p.y / kGrid))};
}

std::vector<Vec2> snapped(std::vector<Vec2> loop) {
  for (Vec2& p : loop) {
    const GridPoint g = on_grid(p);
    p = {static_cast<double>(g.x) * kGrid, static_cast<double>(g.y) * kGrid};
  }
  return loop;
}

/// Winding of exact integers: neither rounding nor tolerance.
Inclusion exact_inclusion(const std::vector<Vec2>& loop, Vec2 point) {
  const GridPoint p = on_grid(point);
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const GridPoint a = on_grid(loop[i]);
    const GridPoint b = on_grid(loop[(i + 1) % loop.size()]);
    const std::int64_t side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const bool within = p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
                        p.y <= std::max(a.y, b.y);
    if (side == 0 && within) return Inclusion::on_boundary;
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside ? Inclusion::inside : Inclusion::outside;
}

/// A star whose 500 walls alternate between two radii, so that every other corner is reflex and many walls are slivers.
std::vector<Vec2> star(int walls) {
  Random random(500);
  std::vector<Vec2> loop;
  for (int i = 0; i < walls; ++i) {
    const double radius = i % 2 == 0 ? random.uniform(40.0, 60.0) : random.uniform(0.5, 20.0);
    loop.push_back(radius * unit_from_angle(kTwoPi * i / walls));
  }
  return snapped(loop);
}

std::vector<Vec2> sliver(double turn) {
  std::vector<Vec2> loop{{0.0, 0.0}, {200.0, 0.0}, {200.0, 0.1}, {0.0, 0.1}};
  for (Vec2& p : loop) p = plans::Motion{false, turn, {}}.apply(p);
  return snapped(loop);
}

/// Vertices, points on walls, one grid step beside them, and points anywhere.
std::vector<Vec2> awkward_points(const std::vector<Vec2>& loop) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i];
    const Vec2 b = loop[(i + 1) % loop.size()];
    for (const Vec2 p : {a, snapped({0.5 * (a + b)})[0], snapped({a + 0.25 * (b - a)})[0]}) {
      points.push_back(p);
      for (const Vec2 beside : {Vec2{kGrid, 0.0}, Vec2{-kGrid, 0.0}, Vec2{0.0, kGrid}, Vec2{0.0, -kGrid}}) {
        points.push_back(p + beside);
      }
      // On the same height or below a vertex, where a ray meets several walls at once.
      points.push_back({p.x - 1.0, p.y});
      points.push_back({p.x, p.y - 1.0});
    }
  }
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    points.push_back(snapped({{random.uniform(-70.0, 260.0), random.uniform(-70.0, 70.0)}})[0]);
  }
  return points;
}

/// How many of a loop's awkward points are classified unlike exact arithmetic does, seen from `shift` away.
Outcome inclusion_differences(const std::vector<Vec2>& loop, Vec2 shift) {
  Loops moved{loop};
  for (Vec2& p : moved[0]) p = p + shift;
  int differences = 0;
  const std::vector<Vec2> points = awkward_points(loop);
  std::string where = "none of " + std::to_string(points.size());
  for (const Vec2 p : points) {
    if (classify(moved, p + shift) == exact_inclusion(loop, p)) continue;
    ++differences;
    where = "(" + number(p.x) + ", " + number(p.y) + ")";
  }
  return worst("as in integer arithmetic", differences, Unit::absolute, 0.0, where);
}

void add_inclusion(std::vector<Case>& table) {
  struct Shape {
    const char* name;
    std::vector<Vec2> loop;
  };
  const std::vector<Shape> shapes{{"a comb of 500 walls", plans::comb_room("comb", 500).boundary[0]},
                                  {"a star of 500 walls", star(500)},
                                  {"a sliver of 0.1 x 200 m", sliver(0.0)},
                                  {"a sliver of 0.1 x 200 m at 17 degrees", sliver(degrees(17.0))}};
  // A shift by 2^20 m (about 1e6) keeps the grid exact, so that the answer must not change at all.
  for (const Shape& shape : shapes) {
    for (const Vec2 shift : {Vec2{}, Vec2{0x1.0p20, -0x1.0p20}}) {
      const std::string far = shift == Vec2{} ? "" : ", 1e6 m off the origin";
      table.push_back({"Inclusion", shape.name + far, [=] { return inclusion_differences(shape.loop, shift); }});
    }
  }
  table.push_back({"Inclusion", "NaN, infinity, 1e300, no loop, an empty loop, a loop of one point", [] {
                     const double nan = std::numeric_limits<double>::quiet_NaN();
                     const double inf = std::numeric_limits<double>::infinity();
                     const Loops box{plans::box_room("box", 5.0, 4.0).boundary[0]};
                     const Loops odd{{}, {{1.0, 1.0}}};
                     bool outside = true;
                     for (const double bad : {nan, inf, -inf, 1e300}) {
                       outside = outside && !contains(box, {bad, 1.0}) && !contains(box, {1.0, bad});
                     }
                     outside = outside && !contains({}, {1.0, 1.0}) && !contains(odd, {2.0, 1.0});
                     return holds("outside", outside, outside ? "outside" : "inside");
                   }});
}

void add_angles(std::vector<Case>& table) {
  table.push_back({"Poses", "a heading turned by 1e6 times 2 pi", [] {
                     return within(0.3, wrap_angle(0.3 + 1e6 * kTwoPi), Unit::absolute, 1e-9);
                   }});
  table.push_back({"Poses", "a heading wrapped 1e6 times while it turns by 2.5 rad each", [] {
                     double heading = 0.0;
                     for (int i = 0; i < 1'000'000; ++i) heading = wrap_angle(heading + 2.5);
                     // Every addition rounds by at most half an ulp of pi.
                     const double difference = wrap_angle(heading - 2.5e6);
                     return within(0.0, difference, Unit::absolute, 1e6 * 0x1.0p-52);
                   }});
  table.push_back({"Poses", "wrapped headings from denormal to 1e300", [] {
                     bool good = true;
                     for (int e = -323; e <= 300; ++e) {
                       for (const double sign : {1.0, -1.0}) {
                         const double w = wrap_angle(sign * std::pow(10.0, e));
                         good = good && w > -kPi && w <= kPi;
                       }
                     }
                     good = good && wrap_angle(-kPi) == kPi && wrap_angle(kPi) == kPi;
                     return holds("in (-pi, pi]", good, good ? "yes" : "no");
                   }});
  for (const double far : {1.0, 1e6}) {
    table.push_back({"Poses", "relative and compose undo each other, " + number(far) + " m off the origin", [=] {
                       Random random(3);
                       double largest = 0.0;
                       for (int i = 0; i < 10000; ++i) {
                         const Pose2 a{{far + random.uniform(), -far}, random.uniform(-4.0, 4.0)};
                         const Pose2 b{{far, random.uniform() - far}, random.uniform(-3.0, 3.0)};
                         const Pose2 back = a.compose(a.relative(b));
                         largest = larger(largest, distance(back.position, b.position));
                         largest = larger(largest, std::fabs(wrap_angle(back.heading - b.heading)));
                       }
                       return worst("the same pose", largest, Unit::absolute, far * 1e-15);
                     }});
  }
}

void add_segments(std::vector<Case>& table) {
  for (const double length : {0.0, 1e-300, 1e-170, 1e-12, 1e12, 1e150}) {
    table.push_back({"Segments", "nearest point of a wall of " + number(length) + " m", [=] {
                       const Segment s{{1.0, 1.0}, {1.0 + length, 1.0}};
                       const double d = distance(s, {1.0, 3.0});
                       return within(2.0, d, Unit::absolute, 1e-11);
                     }});
  }
  table.push_back({"Segments", "signed area of a 5 x 4 m room 1e6 m off the origin", [] {
                     std::vector<Vec2> loop = plans::box_room("box", 5.0, 4.0).boundary[0];
                     for (Vec2& p : loop) p = p + Vec2{1e6, 1e6};
                     return within(20.0, signed_area(loop), Unit::relative, 1e-15);
                   }});
}

/// Largest difference between what a room's sensors read and what they read in the same room moved, over many poses.
/// Poses where anything within the tolerance decides who answers are the ones at which kinds differ; they are counted.
Outcome moved_ranges(const Room& room, const plans::Motion& motion, double bound, double tolerated_switches) {
  const BeltConfig belt;
  const DetectionTable detection(belt);
  const RangeModel here(room, {}, belt, detection);
  const RangeModel there(plans::moved(room, motion), {}, belt, detection);
  Random random(11);
  double largest = 0.0;
  int switches = 0;
  int compared = 0;
  while (compared < 3000) {
    const Pose2 pose{{random.uniform(0.0, 6.0), random.uniform(0.0, 5.0)}, random.uniform(-kPi, kPi)};
    if (!contains(room.boundary, pose.position)) continue;
    for (int sensor = 0; sensor < belt.sensors; ++sensor) {
      // A mirrored belt fires the other way round.
      const int mirrored = motion.mirrored ? (belt.sensors - sensor) % belt.sensors : sensor;
      const PredictedEcho a = here.predict(pose, sensor);
      const PredictedEcho b =
          there.predict({motion.apply(pose.position), motion.apply_heading(pose.heading)}, mirrored);
      switches += a.kind != b.kind;
      if (a.kind == b.kind && a.has_echo()) largest = larger(largest, std::fabs(a.range_m - b.range_m));
    }
    ++compared;
  }
  if (switches > tolerated_switches) largest = std::numeric_limits<double>::infinity();
  return worst("the same ranges", largest, Unit::absolute, bound,
               std::to_string(switches) + " of 45,000 firings answered by another reflector");
}

void add_motions(std::vector<Case>& table) {
  const auto add = [&](std::string name, plans::Motion motion, double bound) {
    table.push_back({"Moved maps", "L-shaped room " + std::move(name),
                     [=] { return moved_ranges(plans::l_room("l"), motion, bound, 0.0); }});
  };
  add("turned by 90 degrees", {false, 0.5 * kPi, {}}, 1e-12);
  add("turned by 31 degrees", {false, degrees(31.0), {3.0, -2.0}}, 1e-12);
  add("mirrored", {true, 0.0, {}}, 1e-12);
  add("mirrored and turned by 77 degrees", {true, degrees(77.0), {-4.0, 1.0}}, 1e-12);
  add("1e6 m off the origin, turned by 31 degrees", {false, degrees(31.0), {1e6, -1e6}}, 1e-9);
}

/// Adds walls that should change nothing to a room, and compares every range.
Outcome disturbed_ranges(const std::vector<Segment>& extra, double bound) {
  const Room plain = plans::l_room("l");
  Room disturbed = plain;
  disturbed.walls.insert(disturbed.walls.end(), extra.begin(), extra.end());
  const BeltConfig belt;
  const DetectionTable detection(belt);
  const RangeModel a(plain, {}, belt, detection);
  const RangeModel b(disturbed, {}, belt, detection);
  Random random(13);
  double largest = 0.0;
  int switches = 0;
  for (int i = 0; i < 4000; ++i) {
    const Pose2 pose{{random.uniform(0.3, 3.2), random.uniform(0.3, 4.7)}, random.uniform(-kPi, kPi)};
    for (int sensor = 0; sensor < belt.sensors; ++sensor) {
      const PredictedEcho one = a.predict(pose, sensor);
      const PredictedEcho two = b.predict(pose, sensor);
      switches += one.has_echo() != two.has_echo();
      if (one.has_echo() && two.has_echo()) largest = larger(largest, std::fabs(one.range_m - two.range_m));
    }
  }
  return worst("the same ranges", switches == 0 ? largest : std::numeric_limits<double>::infinity(), Unit::absolute,
               bound, std::to_string(switches) + " of 60,000 echoes come or go");
}

void add_degenerate_walls(std::vector<Case>& table) {
  const auto add = [&](std::string name, std::vector<Segment> extra, double bound) {
    table.push_back({"Degenerate walls", std::move(name),
                     [=, extra = std::move(extra)] { return disturbed_ranges(extra, bound); }});
  };
  add("a wall of zero length", {{{2.0, 0.0}, {2.0, 0.0}}}, 0.0);
  add("a wall of 1e-12 m", {{{2.0, 0.0}, {2.0, 1e-12}}}, 0.0);
  add("a wall of 1e-300 m", {{{0.0, 0.0}, {1e-300, 1e-300}}}, 0.0);
  add("a wall drawn twice", {{{0.0, 0.0}, {6.0, 0.0}}}, 0.0);
  add("a wall drawn twice, backwards", {{{6.0, 0.0}, {0.0, 0.0}}}, 0.0);
  add("a second wall 1e-9 m behind", {{{0.0, -1e-9}, {6.0, -1e-9}}}, 1e-12);
  add("a second wall 1e-12 rad from parallel", {{{0.0, -1e-9}, {6.0, -1e-9 + 6e-12}}}, 1e-12);
  add("a wall in two pieces that leave 1e-9 m between them",
      {{{0.0, 0.0}, {3.0, 0.0}}, {{3.0 + 1e-9, 0.0}, {6.0, 0.0}}}, 1e-12);
}

}  // namespace

void add_geometry(std::vector<Case>& table) {
  add_angles(table);
  add_segments(table);
  add_inclusion(table);
  add_motions(table);
  add_degenerate_walls(table);
}

}  // namespace echoway::stiff
