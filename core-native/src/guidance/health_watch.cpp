#include "guidance/health_watch.hpp"

#include <algorithm>

#include "echoway/geometry/pose2.hpp"
#include "echoway/units.hpp"

namespace echoway::guidance {
namespace {

bool blocked(SensorState state) noexcept {
  return state == SensorState::silent || state == SensorState::stuck || state == SensorState::fault;
}

}  // namespace

void HealthWatch::update(const BeltHealth& health, double now, Announcer& voice) {
  if (health.link == BeltLink::lost && told_link_ != BeltLink::lost) {
    if (voice.offer(make_cue(CueKind::belt_lost), now, true)) told_link_ = BeltLink::lost;
    return;
  }
  if (health.link == BeltLink::connected && told_link_ != BeltLink::connected) {
    // The first connection is told too: silence must mean that all is well.
    if (voice.offer(make_cue(CueKind::belt_back), now, true)) told_link_ = BeltLink::connected;
    return;
  }
  if (health.link != BeltLink::connected) return;
  if (health.has_battery && health.battery_v >= kRecovered) told_battery_ = false;
  if (health.has_battery && health.battery_v < kLowBattery && !told_battery_) {
    told_battery_ = voice.offer(make_cue(CueKind::battery_low), now);
    return;
  }
  const int sensors = std::clamp(health.sensor_count, 0, kMaxSensors);
  for (int i = 0; i < sensors; ++i) {
    bool& told = told_sensor_[static_cast<std::size_t>(i)];
    const bool is_blocked = blocked(health.sensors[static_cast<std::size_t>(i)].state);
    if (!is_blocked) told = false;
    if (!is_blocked || told) continue;
    Cue cue = make_cue(CueKind::sensor_blocked);
    cue.direction = wrap_angle(kTwoPi * i / sensors);
    cue.has_direction = true;
    told = voice.offer(cue, now);
    return;
  }
}

}  // namespace echoway::guidance
