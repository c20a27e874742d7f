#include "thesis/scan.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::thesis {
namespace {

// A pause this much longer than the slowest belt that is still at work means that it was away meanwhile.
constexpr double kPauseAllowance = 2.0;  // seconds
// Equal readings must not be outliers of their own rounded mean.
constexpr double kRounding = 1e-9;       // metres

}  // namespace

ScanAssembler::ScanAssembler(const BeltConfig& belt, const ThesisParameters& parameters)
    : belt_(belt), parameters_(parameters) {
  // One sensor alone still at work fires once a pass.
  longest_gap_s_ = kPauseAllowance + parameters.passes * belt.sensors * belt.slot_s;
}

void ScanAssembler::restart() noexcept {
  tally_.fill({});
  full_ = 0;
  firings_ = 0;
  time_offsets_ = 0.0;
}

bool ScanAssembler::add(const Firing& firing) {
  if (firings_ > 0 && firing.time_s - last_time_ > longest_gap_s_) restart();
  Tally& tally = tally_[static_cast<std::size_t>(firing.sensor)];
  bool completed = false;
  if (tally.fired >= parameters_.passes) {
    complete();
    completed = true;
  }
  if (firings_ == 0) first_time_ = firing.time_s;
  ++firings_;
  last_time_ = firing.time_s;
  time_offsets_ += firing.time_s - first_time_;
  ++tally.fired;
  if (firing.has_echo() && firing.range_m <= belt_.max_range_m) {
    ++tally.echoes;
    tally.sum += firing.range_m;
  }
  if (tally.fired == parameters_.passes && ++full_ == belt_.sensors) {
    complete();
    completed = true;
  }
  return completed;
}

void ScanAssembler::complete() {
  scan_.time_s = first_time_ + time_offsets_ / firings_;
  const double missing = parameters_.missing_range_factor * belt_.max_range_m;
  scan_.mute_count = 0;
  int count = 0;
  for (int sensor = 0; sensor < belt_.sensors; ++sensor) {
    const Tally& tally = tally_[static_cast<std::size_t>(sensor)];
    // The thesis's missing echo is a reading of twice the maximum range that is eliminated later. Averaging it with a
    // real echo of the other pass would make a range that nothing is at, so only echoes are averaged.
    const double range = tally.echoes > 0 ? tally.sum / tally.echoes : missing;
    if (range <= belt_.max_range_m) {
      scan_.kept[static_cast<std::size_t>(count++)] = {sensor, range};
    } else if (tally.fired > 0) {
      scan_.mute[static_cast<std::size_t>(scan_.mute_count++)] = sensor;
    }
  }
  const auto all = std::span(scan_.kept).first(static_cast<std::size_t>(count));
  scan_.kept_count = drop_outliers(all, parameters_.outlier_deviations);
  restart();
}

int drop_outliers(std::span<Reading> readings, double deviations) noexcept {
  if (readings.empty()) return 0;
  const double n = static_cast<double>(readings.size());
  double mean = 0.0;
  for (const Reading& r : readings) mean += r.range_m / n;
  double variance = 0.0;
  for (const Reading& r : readings) variance += (r.range_m - mean) * (r.range_m - mean) / n;
  const double limit = mean + deviations * std::sqrt(variance) + kRounding;
  const auto end =
      std::remove_if(readings.begin(), readings.end(), [&](const Reading& r) { return r.range_m > limit; });
  return static_cast<int>(end - readings.begin());
}

}  // namespace echoway::thesis
