#include "tracker/sensor_health.hpp"

#include <algorithm>

namespace echoway::tracker {
namespace {
constexpr int kOrdinarySilence = 7;     // Silent firings in a row that any room produces.
constexpr int kStrangeSilence = 15;     // From here on the belt is covered.
}  // namespace

double SensorHealth::on_firing(int, bool echo, double) noexcept {
  if (echo) {
    silent_run_ = 0;
    return 1.0;
  }
  ++silent_run_;
  return std::clamp(static_cast<double>(kStrangeSilence - silent_run_) / (kStrangeSilence - kOrdinarySilence), 0.0, 1.0);
}

}  // namespace echoway::tracker
