#include "tracker/sensor_health.hpp"

#include <algorithm>
#include <cmath>

namespace echoway::tracker {
namespace {

constexpr int kOrdinarySilence = 7;       // Silent firings of the whole belt in a row that any room produces.
constexpr int kStrangeSilence = 15;       // From here on the belt is covered.
constexpr double kSameRange = 0.03;       // Metres.
constexpr int kStuckRepeats = 10;
constexpr double kStuckProgress = 12.0;   // Three metres, or a turn by 96 degrees.
constexpr int kSilentFirings = 45;
constexpr double kSilentProgress = 45.0;
constexpr double kNear = 2.0;             // Metres within which ballasts make false readings (thesis 6.2.5, case III).
constexpr double kMemory = 1.0 / 14.0;
constexpr double kMostlyUnmapped = 0.80;
constexpr double kClearedUnmapped = 0.35;
constexpr int kFirstJudgement = 20;
constexpr int kFewOutOf = 5;              // More than one sensor in so many: the place is wrong, or the room.

}  // namespace

double SensorHealth::trust(int sensor, bool echo) noexcept {
  if (records_[static_cast<std::size_t>(sensor)].suspect) return 0.0;
  if (echo) {
    silent_run_ = 0;
    return 1.0;
  }
  ++silent_run_;
  const auto left = static_cast<double>(kStrangeSilence - silent_run_);
  return std::clamp(left / (kStrangeSilence - kOrdinarySilence), 0.0, 1.0);
}

void SensorHealth::judge(int sensor, bool echo, double range, double progress, double unmapped) noexcept {
  Record& r = records_[static_cast<std::size_t>(sensor)];
  if (!echo) {
    // While the whole belt is covered nobody's silence is his own fault.
    if (r.silence == 0 || silent_run_ > kStrangeSilence) r.silent_since = progress;
    r.silence = silent_run_ > kStrangeSilence ? 0 : r.silence + 1;
    r.repeats = 0;
    r.near_unmapped -= kMemory * r.near_unmapped;
  } else {
    r.silence = 0;
    if (r.repeats > 0 && std::abs(range - r.range) < kSameRange) {
      ++r.repeats;
    } else {
      r.range = range;
      r.repeats = 1;
      r.repeats_since = progress;
    }
    r.near_unmapped += kMemory * ((range < kNear ? unmapped : 0.0) - r.near_unmapped);
  }
  ++r.judged;
  const bool was = r.suspect;
  if (r.repeats >= kStuckRepeats && progress - r.repeats_since > kStuckProgress) {
    r.suspect = true;
    r.kind = SensorSuspicion::Kind::stuck;
  } else if (r.silence >= kSilentFirings && progress - r.silent_since > kSilentProgress) {
    r.suspect = true;
    r.kind = SensorSuspicion::Kind::silent;
  } else if (r.judged >= kFirstJudgement && r.near_unmapped > kMostlyUnmapped) {
    r.suspect = true;
    r.kind = SensorSuspicion::Kind::interference;
  } else if (r.suspect) {
    r.suspect = r.kind == SensorSuspicion::Kind::interference && r.near_unmapped > kClearedUnmapped;
  }
  if (r.suspect && !was && too_many(r.kind)) acquit(r.kind);
  if (r.suspect || was) list_suspicions();
}

// Whoever is lost finds all readings unexplained. Blaming the sensors would take away the evidence that leads back.
bool SensorHealth::too_many(SensorSuspicion::Kind kind) const noexcept {
  int suspects = 0;
  for (int i = 0; i < sensors_; ++i) {
    const Record& r = records_[static_cast<std::size_t>(i)];
    suspects += r.suspect && r.kind == kind;
  }
  return kind != SensorSuspicion::Kind::silent && suspects > std::max(1, sensors_ / kFewOutOf);
}

void SensorHealth::acquit(SensorSuspicion::Kind kind) noexcept {
  for (Record& r : records_) {
    if (!r.suspect || r.kind != kind) continue;
    r.suspect = false;
    r.repeats = 0;
    r.near_unmapped = 0.0;
    r.judged = 0;
  }
  list_suspicions();
}

void SensorHealth::list_suspicions() noexcept {
  count_ = 0;
  for (int i = 0; i < sensors_; ++i) {
    const Record& r = records_[static_cast<std::size_t>(i)];
    if (r.suspect) suspicions_[count_++] = {i, r.kind};
  }
}

}  // namespace echoway::tracker
