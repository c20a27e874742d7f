#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "echoway/belt/belt.hpp"
#include "echoway/belt/belt_health.hpp"
#include "echoway/locate/locator.hpp"

namespace echoway {

/// Counts events over the last minute in one-second bins.
class MinuteCounter {
 public:
  void add(double time_s) noexcept;
  /// It is now `time_s`, and nothing happened.
  void advance(double time_s) noexcept;
  [[nodiscard]] int total(double now_s) noexcept;

 private:
  static constexpr int kBins = 60;

  std::array<std::uint16_t, kBins> bins_{};
  std::int64_t newest_second_ = -1;
  int total_ = 0;
};

/// Watches the belt's sentences and keeps its BeltHealth. Times are seconds on one clock; nothing is allocated.
class BeltMonitor {
 public:
  explicit BeltMonitor(int sensor_count);

  /// Some sentence arrived. Firings are stamped earlier than they arrive; only the arrival says that the line lives.
  void heard(double time_s);
  void on_firing(const Firing& firing);
  void on_fault(int sensor, int code, double time_s);
  /// A status sentence; what the belt left empty is unset.
  void on_status(std::optional<int> sensors, std::string_view firmware, std::optional<double> temperature_c,
                 std::optional<double> battery_v, double time_s);
  void on_detached();
  void on_tick(double now_s);

  /// What the locator thinks of the sensors; replaces what it thought before.
  void set_suspicions(std::span<const SensorSuspicion> suspicions);

  [[nodiscard]] const BeltHealth& health() const noexcept { return health_; }
  /// The sentence counters, for whoever decodes.
  [[nodiscard]] BeltHealth& counters() noexcept { return health_; }

 private:
  struct Watch {
    MinuteCounter firings;
    MinuteCounter echoes;
    int covered_run = 0;       // consecutive readings at the shortest range
    bool suspected = false;
    SensorState suspicion = SensorState::unknown;
  };

  void judge_all(double now_s);
  [[nodiscard]] SensorState judge(std::size_t sensor, double now_s) const;

  BeltHealth health_;
  std::array<Watch, kMaxSensors> watches_{};
  double last_heard_ = -1.0;
  double connected_since_ = -1.0;
  double first_firing_ = -1.0;
  double interval_ = 0.0;      // smoothed time between two firings
  double last_firing_ = -1.0;
};

}  // namespace echoway
