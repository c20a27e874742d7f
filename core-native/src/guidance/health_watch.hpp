#pragma once

#include <array>

#include "echoway/belt/belt_health.hpp"
#include "echoway/guidance/cue.hpp"
#include "guidance/announcer.hpp"

namespace echoway::guidance {

/// Tells what a wearer must know of the belt: lost and back, a blocked sensor, a low battery.
class HealthWatch {
 public:
  /// Volts. The ranging modules need 4.5 at least; below this little is left of the belt's 6 V pack. Told once until it
  /// has recovered. The app goes by the same.
  static constexpr double kLowBattery = 5.2;
  static constexpr double kRecovered = 5.6;

  /// Offers at most one line to `voice`.
  void update(const BeltHealth& health, double now, Announcer& voice);

 private:
  BeltLink told_link_ = BeltLink::absent;
  bool told_battery_ = false;
  std::array<bool, kMaxSensors> told_sensor_{};
};

}  // namespace echoway::guidance
