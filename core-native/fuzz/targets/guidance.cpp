// The guide fed estimates that no tracker would make of one walk, but each of which a tracker might make: leaps, every
// degree of doubt, every room.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "echoway/guidance/guide.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"
#include "reader.hpp"
#include "target.hpp"
#include "wishes.hpp"

namespace echoway::fuzz {
namespace {

constexpr int kMostCalls = 400;

/// Mostly a step from the last one.
class Wanderer {
 public:
  Estimate next(Reader& in, double time) {
    const std::uint8_t how = in.byte();
    Estimate& e = last_;
    e.time_s = time;
    if (how < 8) e.room = how % 3 - 1;
    const Vec2 step{0.01 * (in.byte() - 128), 0.01 * (in.byte() - 128)};
    e.pose.position = how % 16 == 9  ? Vec2{100.0 * step.x, 100.0 * step.y}
                      : how % 4 == 0 ? in.spot()
                                     : e.pose.position + 0.2 * step;
    e.pose.heading = how % 4 == 1 ? e.pose.heading : wrap_angle(0.0246 * in.byte());
    e.sigma_m = how % 32 == 31 ? 30.0 : 0.01 * in.byte();
    e.sigma_heading_rad = 0.01 * in.byte();
    e.room_probability = how % 2 == 0 ? 1.0 : in.byte() / 255.0;
    e.state = how < 128 ? TrackState::tracking : static_cast<TrackState>(in.byte() % 3);
    e.speed_mps = 0.02 * (in.byte() - 64);
    e.covariance_xx = e.covariance_yy = e.sigma_m * e.sigma_m;
    return e;
  }

 private:
  Estimate last_{.room = 0, .pose = {{1.0, 1.0}, 0.0}};
};

BeltHealth any_health(Reader& in) {
  BeltHealth health;
  health.link = static_cast<BeltLink>(in.byte() % 3);
  health.sensor_count = in.byte() % (kMaxSensors + 1);
  health.firings_per_second = in.byte();
  for (int i = 0; i < health.sensor_count; ++i) {
    SensorHealth& sensor = health.sensors[static_cast<std::size_t>(i)];
    sensor.state = static_cast<SensorState>(in.byte() % 6);
    sensor.firings = in.byte();
    sensor.echoes = std::min<int>(in.byte(), sensor.firings);
  }
  health.has_battery = in.byte() % 2 == 0;
  health.battery_v = 0.05 * in.byte();
  return health;
}

void estimate(Guide& guide, Reader& in, Wanderer& wearer, double time) {
  const Estimate now = wearer.next(in, time);
  const std::array<Hypothesis, 1> places{{{now.room, now.pose, now.sigma_m, now.room_probability}}};
  guide.on_estimate(now, std::span(places).first(now.room == kNoRoom ? 0 : 1));
  static_cast<void>(guide.take_level_transition());
}

void call(Guide& guide, Reader& in, Wanderer& wearer, Clock& clock) {
  const std::uint8_t choice = in.byte();
  const std::uint8_t what = choice % 16;
  double time = clock.next(in);
  if (!std::isfinite(time)) time = 0.0;  // The session lets none of these through.
  switch (what) {
    case 0:
    case 1:
    case 2: guide.on_firing({time, in.byte() % 15, static_cast<double>(in.byte()) / 24.0}); break;
    case 3: guide.on_firing({time, static_cast<int>(in.byte()) - 8, 0.02 * in.word()}); break;
    case 4: guide.on_belt_health(any_health(in), time); break;
    case 5: guide.on_start({0, Vec2{1.0, 1.0}, choice < 128 ? std::optional(0.0) : std::nullopt}); break;
    case 6:
    case 7: static_cast<void>(ask(guide, in)); break;
    default: estimate(guide, in, wearer, time);
  }
}

}  // namespace

std::string guidance(Bytes data) {
  static const Building building = plans::guided_closets();
  static const Router router(building);
  Guide guide(router);
  Reader in(data);
  Wanderer wearer;
  Clock clock;
  for (int i = 0; i < kMostCalls && !in.empty(); ++i) {
    call(guide, in, wearer, clock);
    if (std::string broken = plans::broken_guidance(guide, building); !broken.empty()) return broken;
  }
  return "";
}

}  // namespace echoway::fuzz
