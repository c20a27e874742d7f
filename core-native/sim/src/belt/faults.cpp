#include "belt/faults.hpp"

namespace echoway::sim {

void SensorFaults::cover(const Cover& cover, double now_s) {
  each(cover.sensors, [until = now_s + cover.seconds](State& state) { state.covered_until_s = until; });
}

void SensorFaults::set(const SensorFault& fault) {
  each(fault.sensors, [&fault](State& state) {
    state.fault = fault.kind;
    state.stuck_at_m = fault.range_m;
  });
}

std::optional<double> SensorFaults::apply(int sensor, double now_s, std::optional<double> range) const {
  const State& state = sensors_[static_cast<std::size_t>(sensor)];
  switch (state.fault) {
    case SensorFault::Kind::dead:
      return std::nullopt;
    case SensorFault::Kind::stuck:
      return state.stuck_at_m;
    case SensorFault::Kind::mended:
      break;
  }
  return now_s < state.covered_until_s ? std::nullopt : range;
}

}  // namespace echoway::sim
