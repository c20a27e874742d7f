#include "tracker/fit_monitor.hpp"

#include <algorithm>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

constexpr double kShortMemory = 1.0 / 64.0;    // Per firing: four seconds.
constexpr double kShortestMemory = 1.0 / 10.0;
constexpr double kLongMemory = 1.0 / 320.0;
constexpr double kShareMemory = 1.0 / 160.0;
constexpr double kMostDoubt = 4.0;
constexpr int kWarmUp = 24;
constexpr double kDoubtfulGain = 0.2;
constexpr double kDoubtfulShare = 0.5;         // Of the usual gain.
constexpr double kPoorGain = 0.08;             // A right place gains 0.4 to 1.2 nats a firing over the reference.
constexpr double kPoorShare = 0.25;            // Of the usual gain.

// What readings look like when nothing is known of the place.
double reference_density(double echo_share, bool echo, double range) noexcept {
  if (!echo) return 1.0 - echo_share;
  return echo_share * (0.75 / 2.0 * fast_exp(-range / 2.0) + 0.25 / 10.5);
}

}  // namespace

double FitMonitor::anywhere(bool echo, double range) const noexcept {
  return reference_density(echo_share_, echo, range);
}

double FitMonitor::gain(double log_density, bool echo, double range) const noexcept {
  return std::clamp(log_density - fast_log(anywhere(echo, range)), -4.0, 4.0);
}

void FitMonitor::observe(double log_density, bool echo, double range) noexcept {
  const double gained = gain(log_density, echo, range);
  shortest_ += kShortestMemory * (gained - shortest_);
  short_ += kShortMemory * (gained - short_);
  long_ += kLongMemory * (gained - long_);
  echo_share_ += kShareMemory * ((echo ? 1.0 : 0.0) - echo_share_);
  echo_share_ = std::clamp(echo_share_, 0.15, 0.85);
  ++observed_;
}

void FitMonitor::reset() noexcept {
  shortest_ = short_ = long_ = 0.5;
  observed_ = 0;
}

double FitMonitor::doubt() const noexcept {
  const double usual = std::max(0.4, long_);
  return std::clamp(1.0 + 4.0 * (0.7 * usual - shortest_) / usual, 1.0, kMostDoubt);
}

bool FitMonitor::doubtful() const noexcept {
  return observed_ >= kWarmUp && short_ < std::max(kDoubtfulGain, kDoubtfulShare * long_);
}

bool FitMonitor::poor() const noexcept {
  return observed_ >= kWarmUp && short_ < std::max(kPoorGain, kPoorShare * long_);
}

}  // namespace echoway::tracker
