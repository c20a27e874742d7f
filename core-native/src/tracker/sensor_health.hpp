#pragma once

#include <array>
#include <span>

#include "echoway/locate/locator.hpp"

namespace echoway::tracker {

/// Says how far each reading may be believed, and notices sensors that do not say what is there.
class SensorHealth {
 public:
  explicit SensorHealth(int sensors) noexcept : sensors_(sensors) {}

  /// Trust in a reading before the map is asked, 0 ... 1. A covered belt hears nothing from any sensor, which says
  /// nothing about the place: after a run of silence longer than rooms produce, silence stops being evidence. Readings
  /// of a suspect sensor count for nothing.
  [[nodiscard]] double trust(int sensor, bool echo) noexcept;

  /// Judges the reading afterwards. `progress` grows by one whenever the wearer has moved or turned enough for a sensor
  /// to see something else; `unmapped` is the probability that nothing in the plan answered, 0 when that is not known.
  void judge(int sensor, bool echo, double range, double progress, double unmapped) noexcept;

  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const noexcept { return {suspicions_.data(), count_}; }

 private:
  struct Record {
    double range = -1.0;          ///< That it keeps repeating,
    int repeats = 0;              ///< so often,
    double repeats_since = 0.0;   ///< since this progress.
    int silence = 0;              ///< Silent firings in a row,
    double silent_since = 0.0;    ///< since this progress, while other sensors heard something.
    double near_unmapped = 0.0;   ///< Running share of near readings that nothing explains.
    int judged = 0;
    bool suspect = false;
    SensorSuspicion::Kind kind = SensorSuspicion::Kind::silent;
  };
  void list_suspicions() noexcept;
  [[nodiscard]] bool too_many(SensorSuspicion::Kind kind) const noexcept;
  void acquit(SensorSuspicion::Kind kind) noexcept;

  int sensors_;
  int silent_run_ = 0;
  std::array<Record, kMaxSensors> records_{};
  std::array<SensorSuspicion, kMaxSensors> suspicions_{};
  std::size_t count_ = 0;
};

}  // namespace echoway::tracker
