#include "acoustics/echo_paths.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {
namespace {

constexpr double kNearest = 0.02;                // Things closer to the face than this count as this far, metres.
constexpr double kFaintest = 0.1;                // Share of the threshold below which a path is not worth its while.
constexpr double kFan = degrees(20.0);           // Planes serve as mirrors so far off the axis of a belt's beam,
constexpr double kInsideNull = degrees(5.0);     // or to so far inside the first null of a wider one;
constexpr double kFanStep = degrees(1.0);        // they are found by rays so far apart.
constexpr double kDirectBeam = degrees(70.0);    // Other rooms are heard when their doorway lies so near the axis,
constexpr double kBesideFan = degrees(5.0);      // by way of a mirror, this near to the fan.
constexpr double kAtTheDoor = 0.3;               // Nearer than this, both rooms of a doorway are heard.
constexpr double kBeyondEnd = 0.3;               // A plane's reflection point may lie this far beyond its end, metres.

// Where the world is looked at from: the transducer itself or its image behind a plane.
struct Vantage {
  Vec2 at{};
  Vec2 axis{};
  const Panel* mirror = nullptr;
  int mirror_room = 0;
  Vec2 along{};  // Unit vector of the mirror.
};

struct Mirror {
  const Panel* panel = nullptr;
  int room = 0;
  Vec2 along{};
};

// norm() is safe against overflow, which costs; rooms are not that large.
double length_of(Vec2 v) { return std::sqrt(squared_norm(v)); }

Vec2 reflect(Vec2 v, Vec2 unit_along) { return 2.0 * dot(v, unit_along) * unit_along - v; }

Vec2 image(Vec2 p, const Mirror& mirror) { return mirror.panel->at.a + reflect(p - mirror.panel->at.a, mirror.along); }

// Where the line from `from` to `to` passes through the segment; false when it does not, or only at an end.
bool passes(Vec2 from, Vec2 to, const Segment& through, Vec2& at) {
  const Vec2 ray = to - from;
  const Vec2 d = through.direction();
  const double denominator = cross(ray, d);
  if (denominator == 0.0) return false;
  const double s = cross(through.a - from, d) / denominator;
  const double t = cross(through.a - from, ray) / denominator;
  if (s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0) return false;
  at = from + s * ray;
  return true;
}

class PathFinder {
 public:
  PathFinder(const View& view, const Receiver& receiver, const Sensor& sensor, const std::vector<Obstacle>& obstacles,
             double max_path_m, std::vector<Arrival>& arrivals)
      : view_(view),
        receiver_(receiver),
        sensor_(sensor),
        obstacles_(obstacles),
        max_path_(max_path_m),
        fan_(std::max(kFan, receiver.first_null() - kInsideNull)),
        arrivals_(arrivals) {}

  void look_straight() {
    look_from({sensor_.face, sensor_.axis, nullptr, 0, {}});
    for (const Obstacle& obstacle : obstacles_) obstacle_echo(obstacle);
  }

  // Planes that the beam meets askew pass it on. A fan of rays finds those in sight (Dudek's model, thesis
  // section 4.3).
  void look_by_mirrors() {
    std::vector<Mirror> mirrors;
    for (double angle = -fan_; angle <= fan_; angle += kFanStep) {
      const Vec2 ray = rotated(unit_from_angle(angle), sensor_.axis);
      const View::Hit hit = view_.first_panel(sensor_.room, sensor_.face, ray, 0.5 * max_path_);
      if (hit.panel == nullptr || (!mirrors.empty() && mirrors.back().panel == hit.panel)) continue;
      const bool known =
          std::any_of(mirrors.begin(), mirrors.end(), [&](const Mirror& mirror) { return mirror.panel == hit.panel; });
      const Mirror mirror{hit.panel, hit.room, (1.0 / hit.panel->at.length()) * hit.panel->at.direction()};
      if (!known && distance(image(sensor_.face, mirror), sensor_.face) > 2.0 * kNearest) mirrors.push_back(mirror);
    }
    for (const Mirror& mirror : mirrors) {
      look_from(
          {image(sensor_.face, mirror), reflect(sensor_.axis, mirror.along), mirror.panel, mirror.room, mirror.along});
    }
    for (const Mirror& first : mirrors) {
      for (const Mirror& second : mirrors) {
        if (first.panel != second.panel && first.room == second.room) triangle(first, second);
      }
    }
  }

 private:
  void look_from(const Vantage& vantage) {
    look_into(vantage, vantage.mirror == nullptr ? sensor_.room : vantage.mirror_room, -1);
  }

  // At a room and, through the doorways that lie in the beam, at those behind.
  void look_into(const Vantage& vantage, int room, int came_from) {
    const View::PlacedRoom& placed = view_.rooms()[static_cast<std::size_t>(room)];
    for (const Panel& panel : placed.scene.panels) {
      if (&panel != vantage.mirror) plane(vantage, room, panel);
    }
    for (const Corner& corner : placed.scene.corners) corner_echo(vantage, room, corner);
    for (const Scatterer& scatterer : placed.scene.scatterers) scatter(vantage, room, scatterer);
    const double beam = vantage.mirror == nullptr ? kDirectBeam : fan_ + kBesideFan;
    for (const View::Portal& portal : placed.portals) {
      if (portal.leads_to < 0 || portal.leads_to == came_from || !in_beam(vantage, portal.opening, beam)) continue;
      look_into(vantage, portal.leads_to, room);
    }
  }

  // Whether any of the segment lies within `half_width` of the vantage's axis and near enough.
  bool in_beam(const Vantage& vantage, const Segment& segment, double half_width) const {
    if (2.0 * distance(segment, vantage.at) > max_path_) return false;
    const auto angle = [&](Vec2 p) {
      const Vec2 d = p - vantage.at;
      return std::atan2(cross(vantage.axis, d), dot(vantage.axis, d));
    };
    const double a = angle(segment.a);
    const double b = angle(segment.b);
    const bool across = a * b < 0.0 && std::abs(a - b) < kPi;
    return across || std::min(std::abs(a), std::abs(b)) < half_width || distance(segment, vantage.at) < kAtTheDoor;
  }

  // Keeps `path_` when sound that leaves and arrives in the given directions (unit vectors away from the transducer)
  // can be noticed at all.
  bool noticeable(double path_m, Vec2 out, Vec2 in, double loss) {
    const double cos_out = dot(out, sensor_.axis);
    const double cos_in = dot(in, sensor_.axis);
    if (path_m > max_path_ || cos_out <= 0.0 || cos_in <= 0.0) return false;
    path_ = {path_m, receiver_.directivity(cos_out) * receiver_.path_amplitude(path_m) * loss, cos_in, in};
    return receiver_.over_threshold(path_m, std::abs(path_.amplitude * receiver_.directivity(cos_in))) > kFaintest;
  }

  Vec2 direction(Vec2 target) const {
    const Vec2 d = target - sensor_.face;
    const double length = length_of(d);
    return length > 1e-9 ? (1.0 / length) * d : sensor_.axis;
  }

  // Of a target that is seen from the vantage, as the transducer sees it.
  Vec2 direction(const Vantage& vantage, Vec2 target) const {
    if (vantage.mirror == nullptr) return direction(target);
    const Vec2 d = target - vantage.at;
    const double length = length_of(d);
    return length > 1e-9 ? reflect((1.0 / length) * d, vantage.along) : sensor_.axis;
  }

  // Out towards `target` as the vantage sees it and back the same way.
  bool noticeable_return(const Vantage& vantage, Vec2 target, double path_m, double loss) {
    const double mirror = vantage.mirror == nullptr ? 1.0 : vantage.mirror->reflectivity * vantage.mirror->reflectivity;
    const Vec2 there = direction(vantage, target);
    return noticeable(path_m, there, there, loss * mirror);
  }

  bool hidden_by_obstacle(Vec2 from, Vec2 to, const Obstacle* but = nullptr) const {
    const Segment ray{from, to};
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& obstacle) {
      return &obstacle != but && distance(ray, obstacle.centre) < 0.8 * obstacle.radius;
    });
  }

  bool hidden_by_wearer(Vec2 from, Vec2 to) const {
    return !(from == sensor_.face) && distance(Segment{from, to}, sensor_.wearer) < sensor_.girth;
  }

  bool clear(int from_room, Vec2 from, int to_room, Vec2 to) const {
    return view_.trace(from_room, from, to) == to_room && !hidden_by_obstacle(from, to) && !hidden_by_wearer(from, to);
  }

  // Whether nothing stands between the transducer, the mirror if any, and the target.
  bool clear(const Vantage& vantage, int room, Vec2 target) const {
    if (vantage.mirror == nullptr) return clear(sensor_.room, sensor_.face, room, target);
    Vec2 bounce;
    return passes(vantage.at, target, vantage.mirror->at, bounce) &&
           clear(sensor_.room, sensor_.face, vantage.mirror_room, bounce) &&
           clear(vantage.mirror_room, bounce, room, target);
  }

  void plane(const Vantage& vantage, int room, const Panel& panel) {
    const Vec2 d = panel.at.direction();
    const double length = length_of(d);
    if (!(length > 0.0)) return;
    const double along = dot(vantage.at - panel.at.a, d) / length;
    if (along < -kBeyondEnd || along > length + kBeyondEnd) return;
    const Vec2 foot = panel.at.a + (along / length) * d;
    const double path = 2.0 * std::max(kNearest, length_of(foot - vantage.at));
    const double taper = receiver_.end_taper(along, path) * receiver_.end_taper(length - along, path);
    if (!noticeable_return(vantage, foot, path, taper * panel.reflectivity)) return;
    if (clear(vantage, room, nearest_point(panel.at, vantage.at))) arrivals_.push_back(path_);
  }

  void corner_echo(const Vantage& vantage, int room, const Corner& corner) {
    const Vec2 to = vantage.at - corner.at;
    if (dot(to, corner.u) <= 0.0 || dot(to, corner.v) <= 0.0) return;
    const double d = std::max(kNearest, length_of(to));
    // The part of the wave that both panels return: as wide as the shorter panel looks from here.
    const double reach = std::min(corner.reach_u * dot(to, corner.v), corner.reach_v * dot(to, corner.u)) / d;
    const double size = 2.0 * receiver_.end_taper(reach, 2.0 * d) - 1.0;
    if (!noticeable_return(vantage, corner.at, 2.0 * d, size * corner.reflectivity)) return;
    if (clear(vantage, room, corner.at)) arrivals_.push_back(path_);
  }

  void scatter(const Vantage& vantage, int room, const Scatterer& scatterer) {
    const double d = std::max(kNearest, length_of(scatterer.at - vantage.at) - scatterer.radius);
    const double loss = scatterer.gain * receiver_.scatter_loss(d, scatterer.radius);
    if (noticeable_return(vantage, scatterer.at, 2.0 * d, loss) && clear(vantage, room, scatterer.at)) {
      arrivals_.push_back(path_);
    }
    if (vantage.mirror == nullptr) return;
    // By the mirror out and straight back, or the other way round: two paths of one length.
    const double back = std::max(kNearest, length_of(scatterer.at - sensor_.face) - scatterer.radius);
    if (noticeable(d + back, direction(vantage, scatterer.at), direction(scatterer.at),
                   2.0 * loss * vantage.mirror->reflectivity) &&
        clear(sensor_.room, sensor_.face, room, scatterer.at) && clear(vantage, room, scatterer.at)) {
      arrivals_.push_back(path_);
    }
  }

  // Transducer, first plane, second plane, transducer. Right angles are left to corner_echo().
  void triangle(const Mirror& first, const Mirror& second) {
    constexpr double kRightAngle = 0.05;
    if (std::abs(dot(first.along, second.along)) < kRightAngle) return;
    const Vec2 once = image(sensor_.face, first);
    const Vec2 twice = image(once, second);
    Vec2 last;
    Vec2 out;
    if (!passes(twice, sensor_.face, second.panel->at, last) || !passes(once, last, first.panel->at, out)) return;
    const double path = distance(twice, sensor_.face);
    const double loss = first.panel->reflectivity * second.panel->reflectivity;
    if (!noticeable(path, direction(out), direction(last), loss)) return;
    if (clear(sensor_.room, sensor_.face, first.room, out) && clear(first.room, out, second.room, last) &&
        clear(sensor_.room, sensor_.face, second.room, last)) {
      arrivals_.push_back(path_);
    }
  }

  void obstacle_echo(const Obstacle& obstacle) {
    const double away = distance(obstacle.centre, sensor_.face);
    const double d = std::max(kNearest, away - obstacle.radius);
    const Vec2 there = direction(obstacle.centre);
    const double loss = receiver_.scatter_loss(d, obstacle.radius) * obstacle.reflectivity;
    if (!noticeable(2.0 * d, there, there, loss)) return;
    const Vec2 front = sensor_.face + (d / std::max(away, d)) * (obstacle.centre - sensor_.face);
    if (view_.trace(sensor_.room, sensor_.face, front) < 0 || hidden_by_obstacle(sensor_.face, front, &obstacle))
      return;
    arrivals_.push_back(path_);
  }

  const View& view_;
  const Receiver& receiver_;
  const Sensor& sensor_;
  const std::vector<Obstacle>& obstacles_;
  double max_path_;
  double fan_;
  std::vector<Arrival>& arrivals_;
  Arrival path_{};
};

}  // namespace

void find_arrivals(const View& view, const Receiver& receiver, const World& world, const Sensor& sensor,
                   const std::vector<Obstacle>& obstacles, double max_path_m, std::vector<Arrival>& arrivals) {
  arrivals.clear();
  PathFinder finder(view, receiver, sensor, obstacles, max_path_m, arrivals);
  finder.look_straight();
  if (world.mirror_paths) finder.look_by_mirrors();
}

}  // namespace echoway::sim
