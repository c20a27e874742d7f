#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "echoway/belt/belt.hpp"
#include "echoway/thesis/parameters.hpp"

namespace echoway::thesis {

/// One usable reading of a scan.
struct Reading {
  int sensor = 0;
  double range_m = 0.0;
};

/// What is left of two passes after averaging and dropping (thesis section 5.1). A sensor that never fired, or whose
/// reading was dropped, is in neither list.
struct Scan {
  double time_s = 0.0;                       ///< Mean time of its firings.
  std::array<Reading, kMaxSensors> kept{};   ///< In order of sensor.
  int kept_count = 0;
  std::array<int, kMaxSensors> mute{};       ///< Sensors that fired and that nothing answered.
  int mute_count = 0;

  [[nodiscard]] std::span<const Reading> readings() const noexcept {
    return {kept.data(), static_cast<std::size_t>(kept_count)};
  }
  [[nodiscard]] std::span<const int> silent() const noexcept {
    return {mute.data(), static_cast<std::size_t>(mute_count)};
  }
};

/// Collects firings into scans of `passes` whole passes. Needs no particular order of sensors: a scan is complete when
/// every sensor has fired `passes` times, or when one would fire once more (others were lost, silent or out of turn).
/// So neither lost nor doubled firings can hold it up.
class ScanAssembler {
 public:
  ScanAssembler(const BeltConfig& belt, const ThesisParameters& parameters);

  /// Takes one firing whose sensor lies in the belt. True when a scan has been completed; it is scan() then.
  bool add(const Firing& firing);
  /// Forgets the firings of an unfinished scan.
  void restart() noexcept;
  [[nodiscard]] const Scan& scan() const noexcept { return scan_; }

 private:
  struct Tally {
    int fired = 0;
    int echoes = 0;
    double sum = 0.0;
  };

  void complete();

  BeltConfig belt_;
  ThesisParameters parameters_;
  double longest_gap_s_ = 0.0;
  std::array<Tally, kMaxSensors> tally_{};
  int full_ = 0;                             ///< Sensors that have fired `passes` times.
  int firings_ = 0;
  double first_time_ = 0.0;
  double last_time_ = 0.0;
  double time_offsets_ = 0.0;                ///< Sum of time since the first firing.
  Scan scan_;
};

/// Drops readings beyond mean + `deviations` standard deviations of all (section 5.1), in place, in order; returns how
/// many stay.
int drop_outliers(std::span<Reading> readings, double deviations) noexcept;

}  // namespace echoway::thesis
