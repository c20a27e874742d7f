#pragma once

#include <array>

#include "echoway/belt/belt_health.hpp"
#include "echoway/guidance/cue.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

/// Tells what a wearer must know of the belt: lost and back, a blocked sensor, a low battery.
class HealthWatch {
 public:
  /// Below this, volts: two of three cells of a 3.6 V pack near their end. Told once until it has recovered.
  static constexpr double kLowBattery = 3.4;
  static constexpr double kRecovered = 3.6;

  /// Offers at most one line to `voice`.
  void update(const BeltHealth& health, double now, Announcer& voice);

 private:
  BeltLink told_link_ = BeltLink::absent;
  bool told_battery_ = false;
  std::array<bool, kMaxSensors> told_sensor_{};
};

}  // namespace echoway::guidance
