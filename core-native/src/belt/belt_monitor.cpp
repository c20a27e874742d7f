#include "echoway/belt/belt_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace echoway {
namespace {

// A sensor that reads less than this many times running is covered: a sleeve, a bag. The transducer itself answers from
// 6 in (0.15 m). A swinging arm or a wall brushed past does not last ten rounds, so neither is reported.
constexpr double kCoveredRange = 0.20;
constexpr int kCoveredRun = 10;
// A sensor that the belt skips for this many rounds of the others is dead.
constexpr double kSkippedRounds = 3.0;
// The firing rate is averaged over about this many firings.
constexpr double kRateMemory = 48.0;
// A longer gap is a pause, not a rate; a shorter one is two stamps of one firing.
constexpr double kLongestInterval = 1.0;
constexpr double kShortestInterval = 1e-4;
// Times this far behind what was heard before mean that the clock was set back.
constexpr double kSetBack = 10.0;

SensorState to_state(SensorSuspicion::Kind kind) {
  switch (kind) {
    case SensorSuspicion::Kind::silent: return SensorState::silent;
    case SensorSuspicion::Kind::stuck: return SensorState::stuck;
    case SensorSuspicion::Kind::interference: return SensorState::interference;
  }
  return SensorState::unknown;
}

}  // namespace

void MinuteCounter::advance(double time_s) noexcept {
  if (!std::isfinite(time_s)) return;
  // Clamped so that a clock that jumps cannot overflow; a day ahead empties the minute all the same.
  const auto second = static_cast<std::int64_t>(std::clamp(std::floor(time_s), -1e15, 1e15));
  if (second < newest_second_ - kBins) {
    // The clock was set back: what was counted before has no place on it.
    bins_.fill(0);
    total_ = 0;
    newest_second_ = second;
  }
  if (second <= newest_second_) return;
  const std::int64_t fresh = std::min<std::int64_t>(second - newest_second_, kBins);
  for (std::int64_t i = 0; i < fresh; ++i) {
    auto& bin = bins_[static_cast<std::size_t>((second - i) % kBins + kBins) % kBins];
    total_ -= bin;
    bin = 0;
  }
  newest_second_ = second;
}

void MinuteCounter::add(double time_s) noexcept {
  if (!std::isfinite(time_s)) return;
  advance(time_s);
  auto& bin = bins_[static_cast<std::size_t>(newest_second_ % kBins + kBins) % kBins];
  if (bin < UINT16_MAX) {
    ++bin;
    ++total_;
  }
}

int MinuteCounter::total(double now_s) noexcept {
  advance(now_s);
  return total_;
}

BeltMonitor::BeltMonitor(int sensor_count) { health_.sensor_count = sensor_count; }

void BeltMonitor::heard(double time_s) {
  if (!std::isfinite(time_s)) return;
  last_heard_ = time_s < last_heard_ - kSetBack ? time_s : std::max(last_heard_, time_s);
  if (health_.link != BeltLink::connected) connected_since_ = time_s;
  health_.link = BeltLink::connected;
}

void BeltMonitor::on_firing(const Firing& firing) {
  if (firing.sensor < 0 || firing.sensor >= kMaxSensors || !std::isfinite(firing.time_s)) return;
  heard(firing.time_s);
  if (first_firing_ < 0.0) first_firing_ = firing.time_s;

  const double gap = firing.time_s - last_firing_;
  if (last_firing_ >= 0.0 && gap > kShortestInterval && gap < kLongestInterval) {
    interval_ = interval_ > 0.0 ? interval_ + (gap - interval_) / kRateMemory : gap;
    health_.firings_per_second = 1.0 / interval_;
  }
  last_firing_ = gap < -kSetBack ? firing.time_s : std::max(last_firing_, firing.time_s);

  const auto sensor = static_cast<std::size_t>(firing.sensor);
  Watch& watch = watches_[sensor];
  SensorHealth& health = health_.sensors[sensor];
  watch.firings.add(firing.time_s);
  // Both see every time, so that a clock that is set back empties both.
  watch.echoes.advance(firing.time_s);
  if (firing.has_echo()) watch.echoes.add(firing.time_s);
  watch.covered_run = firing.has_echo() && firing.range_m < kCoveredRange ? watch.covered_run + 1 : 0;
  health.last_range_m = firing.range_m;
  health.last_time_s = firing.time_s;
  // An echo that is no cover's proves that the fault is over.
  if (firing.has_echo() && watch.covered_run == 0) health.fault_code = 0;
  health.state = judge(sensor, firing.time_s);
}

void BeltMonitor::on_fault(int sensor, int code, double time_s) {
  heard(time_s);
  if (sensor < 0 || sensor >= kMaxSensors) return;
  SensorHealth& health = health_.sensors[static_cast<std::size_t>(sensor)];
  health.fault_code = code;
  health.state = judge(static_cast<std::size_t>(sensor), time_s);
}

void BeltMonitor::on_status(std::optional<int> sensors, std::string_view firmware, std::optional<double> temperature_c,
                            std::optional<double> battery_v, double time_s) {
  heard(time_s);
  if (sensors && *sensors >= 1 && *sensors <= kMaxSensors) health_.sensor_count = *sensors;
  if (!firmware.empty()) {
    const std::size_t length = std::min(firmware.size(), health_.firmware.size() - 1);
    std::copy_n(firmware.begin(), length, health_.firmware.begin());
    health_.firmware[length] = '\0';
  }
  if (temperature_c) {
    health_.has_temperature = true;
    health_.temperature_c = *temperature_c;
  }
  if (battery_v) {
    health_.has_battery = true;
    health_.battery_v = *battery_v;
  }
}

void BeltMonitor::on_detached() {
  if (health_.link == BeltLink::connected) health_.link = BeltLink::lost;
}

void BeltMonitor::on_tick(double now_s) {
  if (!std::isfinite(now_s)) return;
  if (now_s < last_heard_ - kSetBack) last_heard_ = now_s;
  if (health_.link == BeltLink::connected && now_s - last_heard_ > kBeltSilenceLimit) health_.link = BeltLink::lost;
  judge_all(now_s);
}

void BeltMonitor::set_suspicions(std::span<const SensorSuspicion> suspicions) {
  for (Watch& watch : watches_) watch.suspected = false;
  for (const SensorSuspicion& suspicion : suspicions) {
    if (suspicion.sensor < 0 || suspicion.sensor >= kMaxSensors) continue;
    Watch& watch = watches_[static_cast<std::size_t>(suspicion.sensor)];
    watch.suspected = true;
    watch.suspicion = to_state(suspicion.kind);
  }
}

void BeltMonitor::judge_all(double now_s) {
  const auto count = static_cast<std::size_t>(health_.sensor_count);
  for (std::size_t i = 0; i < count; ++i) {
    health_.sensors[i].firings = watches_[i].firings.total(now_s);
    health_.sensors[i].echoes = watches_[i].echoes.total(now_s);
    health_.sensors[i].state = judge(i, last_firing_);
  }
}

SensorState BeltMonitor::judge(std::size_t sensor, double now_s) const {
  const Watch& watch = watches_[sensor];
  const SensorHealth& health = health_.sensors[sensor];
  if (health.fault_code != 0) return SensorState::fault;
  const double patience = kSkippedRounds * interval_ * health_.sensor_count;
  // What was missed while the belt was away is no sensor's fault.
  const double last = std::max(health.last_time_s >= 0.0 ? health.last_time_s : first_firing_, connected_since_);
  if (interval_ > 0.0 && now_s - last > patience) return SensorState::silent;
  if (health.last_time_s < 0.0) return SensorState::unknown;
  if (watch.covered_run >= kCoveredRun) return SensorState::stuck;
  if (watch.suspected) return watch.suspicion;
  return SensorState::good;
}

}  // namespace echoway
