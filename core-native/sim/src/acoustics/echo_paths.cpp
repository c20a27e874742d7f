#include "acoustics/echo_paths.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::sim {
namespace {

constexpr double kNearest = 0.02;  // Things closer than this to the face are taken to be this far, metres.

// Where the world is looked at from: the transducer itself or its image behind a plane.
struct Vantage {
  Vec2 at{};
  Vec2 axis{};                    // The beam's axis, mirrored along.
  const Panel* mirror = nullptr;
  int mirror_room = 0;
  double loss = 1.0;              // Amplitude left by the mirror, both ways.
};

Vec2 reflect(Vec2 v, Vec2 unit_along) { return 2.0 * dot(v, unit_along) * unit_along - v; }

class PathFinder {
 public:
  PathFinder(const View& view, const Receiver& receiver, const Sensor& sensor, const std::vector<Obstacle>& obstacles,
             double max_path_m, std::vector<Arrival>& arrivals)
      : view_(view),
        receiver_(receiver),
        sensor_(sensor),
        obstacles_(obstacles),
        max_path_(max_path_m),
        arrivals_(arrivals) {}

  void look_from(const Vantage& vantage) {
    for (std::size_t i = 0; i < view_.rooms().size(); ++i) {
      const int room = static_cast<int>(i);
      const RoomScene& scene = view_.rooms()[i].scene;
      for (const Panel& panel : scene.panels) {
        if (&panel != vantage.mirror) plane(vantage, room, panel);
      }
      for (const Corner& corner : scene.corners) corner_echo(vantage, room, corner);
      for (const Scatterer& scatterer : scene.scatterers) scatter(vantage, room, scatterer);
    }
  }

  void look_at_obstacles() {
    for (const Obstacle& obstacle : obstacles_) {
      const double distance_m = std::max(kNearest, distance(obstacle.disc.centre, sensor_.face) - obstacle.disc.radius);
      const double loss = receiver_.scatter_loss(distance_m, obstacle.disc.radius) * obstacle.reflectivity;
      if (noticeable(direct(), obstacle.disc.centre, 2.0 * distance_m, loss)) {
        arrivals_.push_back({2.0 * distance_m, amplitude_});
      }
    }
  }

  [[nodiscard]] Vantage direct() const { return {sensor_.face, sensor_.axis, nullptr, 0, 1.0}; }

  // Planes that the beam meets askew and that pass it on.
  void look_by_mirrors() {
    for (std::size_t i = 0; i < view_.rooms().size(); ++i) {
      for (const Panel& panel : view_.rooms()[i].scene.panels) {
        const double length = panel.at.length();
        if (!(length > 0.05)) continue;
        const Vec2 along = (1.0 / length) * panel.at.direction();
        if (!in_main_lobe(panel.at)) continue;
        Vantage vantage;
        vantage.at = panel.at.a + reflect(sensor_.face - panel.at.a, along);
        vantage.axis = reflect(sensor_.axis, along);
        vantage.mirror = &panel;
        vantage.mirror_room = static_cast<int>(i);
        vantage.loss = panel.reflectivity * panel.reflectivity;
        if (distance(vantage.at, sensor_.face) < 2.0 * kNearest) continue;
        look_from(vantage);
      }
    }
  }

 private:
  // Whether a path from the vantage towards `target` can be noticed at all; leaves its amplitude in amplitude_.
  bool noticeable(const Vantage& vantage, Vec2 target, double path_m, double loss) {
    if (path_m > max_path_) return false;
    const Vec2 to = target - vantage.at;
    const double d = norm(to);
    const double cosine = d > 1e-9 ? dot(to, vantage.axis) / d : 1.0;
    if (cosine <= 0.0) return false;
    amplitude_ = receiver_.mirror_amplitude(path_m, cosine, cosine) * loss * vantage.loss;
    return receiver_.over_threshold({path_m, amplitude_}) > 0.1;
  }

  // Whether nothing stands between the transducer and the target, which lies in placed room `room`.
  bool clear(const Vantage& vantage, int room, Vec2 target) const {
    Vec2 from = sensor_.face;
    int start = sensor_.room;
    if (vantage.mirror != nullptr) {
      const Segment& mirror = vantage.mirror->at;
      const Vec2 ray = target - vantage.at;
      const double denominator = cross(ray, mirror.direction());
      if (denominator == 0.0) return false;
      const double s = cross(mirror.a - vantage.at, mirror.direction()) / denominator;
      const double t = cross(mirror.a - vantage.at, ray) / denominator;
      if (s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0) return false;
      const Vec2 bounce = vantage.at + s * ray;
      if (view_.trace(start, from, bounce) != vantage.mirror_room || hidden_by_obstacle(from, bounce)) return false;
      from = bounce;
      start = vantage.mirror_room;
    }
    return view_.trace(start, from, target) == room && !hidden_by_obstacle(from, target);
  }

  bool hidden_by_obstacle(Vec2 from, Vec2 to) const {
    const Segment ray{from, to};
    return std::any_of(obstacles_.begin(), obstacles_.end(), [&](const Obstacle& obstacle) {
      return distance(ray, obstacle.disc.centre) < 0.8 * obstacle.disc.radius;
    });
  }

  void plane(const Vantage& vantage, int room, const Panel& panel) {
    const double length2 = squared_norm(panel.at.direction());
    if (!(length2 > 0.0)) return;
    const double t = dot(vantage.at - panel.at.a, panel.at.direction()) / length2;
    const double length = std::sqrt(length2);
    if (t * length < -0.3 || (t - 1.0) * length > 0.3) return;
    const Vec2 foot = panel.at.a + t * panel.at.direction();
    const double path = 2.0 * std::max(kNearest, distance(foot, vantage.at));
    const double taper = receiver_.end_taper(t * length, path) * receiver_.end_taper((1.0 - t) * length, path);
    if (!noticeable(vantage, foot, path, taper * panel.reflectivity)) return;
    if (clear(vantage, room, nearest_point(panel.at, vantage.at))) arrivals_.push_back({path, amplitude_});
  }

  void corner_echo(const Vantage& vantage, int room, const Corner& corner) {
    const Vec2 to = vantage.at - corner.at;
    if (dot(to, corner.u) <= 0.0 || dot(to, corner.v) <= 0.0) return;
    const double d = std::max(kNearest, norm(to));
    // The part of the wave that both panels return: as wide as the shorter panel looks from here.
    const double reach = std::min(corner.reach_u * dot(to, corner.v), corner.reach_v * dot(to, corner.u)) / d;
    const double size = 2.0 * receiver_.end_taper(reach, 2.0 * d) - 1.0;
    if (!noticeable(vantage, corner.at, 2.0 * d, size * corner.reflectivity)) return;
    if (clear(vantage, room, corner.at)) arrivals_.push_back({2.0 * d, amplitude_});
  }

  void scatter(const Vantage& vantage, int room, const Scatterer& scatterer) {
    const double d = std::max(kNearest, distance(scatterer.at, vantage.at) - scatterer.radius);
    if (!noticeable(vantage, scatterer.at, 2.0 * d, scatterer.gain * receiver_.scatter_loss(d, scatterer.radius))) return;
    if (clear(vantage, room, scatterer.at)) arrivals_.push_back({2.0 * d, amplitude_});
  }

  // Whether the beam, 25 degrees to either side, meets the segment.
  bool in_main_lobe(const Segment& segment) const {
    constexpr double kHalfWidth = 0.4663;  // tan 25 degrees
    const auto local = [&](Vec2 p) {
      const Vec2 d = p - sensor_.face;
      return Vec2{dot(d, sensor_.axis), cross(sensor_.axis, d)};
    };
    const Vec2 a = local(segment.a);
    const Vec2 b = local(segment.b);
    if (a.x <= 0.0 && b.x <= 0.0) return false;
    return !(a.y > kHalfWidth * a.x && b.y > kHalfWidth * b.x) && !(a.y < -kHalfWidth * a.x && b.y < -kHalfWidth * b.x);
  }

  const View& view_;
  const Receiver& receiver_;
  const Sensor& sensor_;
  const std::vector<Obstacle>& obstacles_;
  double max_path_;
  std::vector<Arrival>& arrivals_;
  double amplitude_ = 0.0;
};

}  // namespace

void find_arrivals(const View& view, const Receiver& receiver, const World& world, const Sensor& sensor,
                   const std::vector<Obstacle>& obstacles, double max_path_m, std::vector<Arrival>& arrivals) {
  arrivals.clear();
  PathFinder finder(view, receiver, sensor, obstacles, max_path_m, arrivals);
  finder.look_at_obstacles();
  finder.look_from(finder.direct());
  if (world.mirror_paths) finder.look_by_mirrors();
}

}  // namespace echoway::sim
