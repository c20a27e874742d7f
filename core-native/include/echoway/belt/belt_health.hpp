#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "echoway/belt/belt.hpp"

namespace echoway {

enum class SensorState : std::uint8_t {
  unknown,       ///< Not heard of yet.
  good,
  silent,        ///< No echo for a whole window although others get some: covered or dead.
  stuck,         ///< The same reading whatever the wearer does.
  interference,  ///< Steady false near readings (thesis section 6.2.5, case III).
  fault,         ///< The belt itself reports a fault (sentence EWF).
};

enum class BeltLink : std::uint8_t {
  absent,     ///< Not attached, or attached and nothing heard yet.
  connected,  ///< Sentences arrive.
  lost,       ///< Was connected; silent for longer than kBeltSilenceLimit, or detached.
};

/// A belt is lost after this long without a usable sentence, seconds: the wearer is told within two.
inline constexpr double kBeltSilenceLimit = 1.5;

/// What one sensor did lately.
struct SensorHealth {
  SensorState state = SensorState::unknown;
  int firings = 0;            ///< In the last minute.
  int echoes = 0;             ///< Of those, with a range.
  double last_range_m = Firing::kNoEcho;
  double last_time_s = -1.0;  ///< Of its newest firing; negative before the first.
  int fault_code = 0;         ///< Newest EWF code; 0 when none.
};

/// How the belt is doing: what a wearer is told, and what a bug report needs. Holds no position.
struct BeltHealth {
  BeltLink link = BeltLink::absent;
  std::array<SensorHealth, kMaxSensors> sensors{};
  int sensor_count = 0;              ///< As configured or as the belt's status sentence says.
  double firings_per_second = 0.0;   ///< Over the last few seconds.
  std::uint64_t good_sentences = 0;
  std::uint64_t bad_checksums = 0;
  std::uint64_t malformed = 0;       ///< Right checksum, wrong contents; or too long.
  std::uint64_t lost_firings = 0;    ///< Gaps in the sequence numbers.
  std::uint64_t restarts = 0;        ///< Times the belt's sequence started over.
  bool has_temperature = false;
  double temperature_c = 0.0;
  bool has_battery = false;
  double battery_v = 0.0;
  std::array<char, 24> firmware{};   ///< NUL-terminated; empty when the belt never said.
};

}  // namespace echoway
