// The belt's side of a session without the costly rest: sentences, the clock that stamps them and what is thought of
// the belt's health, as Session puts them together.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "echoway/belt/belt_monitor.hpp"
#include "echoway/belt/firing_clock.hpp"
#include "plans/session_promises.hpp"
#include "reader.hpp"
#include "target.hpp"
#include "wishes.hpp"

namespace echoway::fuzz {
namespace {

constexpr int kMostCalls = 600;
constexpr double kSetBack = 10.0;  ///< Seconds by which a host's clock must go back before a stamp may.

class Belt {
 public:
  explicit Belt(Reader& in) : in_(in), sensors_(1 + in.byte() % kMaxSensors), clock_(0.0624), monitor_(sensors_) {}

  /// Returns which promise was broken.
  std::string call() {
    const std::uint8_t what = in_.byte() % 16;
    const double time = host_.next(in_);
    if (what == 0) {
      monitor_.on_tick(time);
    } else if (std::isfinite(time)) {
      if (std::string broken = take(what, time); !broken.empty()) return broken;
    }
    return plans::broken_health(monitor_.health());
  }

 private:
  std::string take(std::uint8_t what, double time) {
    monitor_.heard(time);
    switch (what) {
      case 1: monitor_.on_fault(static_cast<int>(in_.byte()) - 8, in_.word(), time); break;
      case 2: status(time); break;
      case 3: monitor_.on_detached(); break;
      case 4: clock_.reset(); break;
      case 5: suspect(); break;
      case 6: seq_ = in_.word(); return fire(time);
      case 7: seq_ = static_cast<std::uint16_t>(seq_ + in_.byte() % 8); return fire(time);
      default: ++seq_; return fire(time);
    }
    return "";
  }

  std::string fire(double arrival) {
    const FiringClock::Stamp stamp = clock_.stamp(seq_, arrival);
    newest_arrival_ = std::max(newest_arrival_, arrival);
    if (!std::isfinite(stamp.time_s)) return "a stamp that is not finite";
    if (stamp.time_s > newest_arrival_ + 1e-9 * (1.0 + std::fabs(newest_arrival_))) {
      return "a stamp after every arrival";
    }
    if (stamp.time_s < last_stamp_ && stamp.time_s > last_stamp_ - kSetBack) return "a stamp that goes back a little";
    last_stamp_ = stamp.time_s;
    const std::uint8_t echo = in_.byte();
    const int sensor = seq_ % sensors_ + (echo == 255 ? 1 : 0);  // now and then one that there is not
    monitor_.on_firing({stamp.time_s, sensor, echo < 64 ? Firing::kNoEcho : echo / 24.0});
    return "";
  }

  void status(double time) {
    const std::uint8_t what = in_.byte();
    const auto sensors = what % 2 == 0 ? std::optional<int>(in_.byte() % kMaxSensors + 1) : std::nullopt;
    const auto celsius = what % 4 < 2 ? std::optional<double>(0.1 * in_.word() - 100.0) : std::nullopt;
    const auto volts = what % 8 < 4 ? std::optional<double>(1e-3 * in_.word()) : std::nullopt;
    monitor_.on_status(sensors, any_name(in_), celsius, volts, time);
  }

  void suspect() {
    std::array<SensorSuspicion, 4> all{};
    for (SensorSuspicion& one : all) {
      one.sensor = static_cast<int>(in_.byte()) - 8;
      one.kind = static_cast<SensorSuspicion::Kind>(in_.byte() % 3);
    }
    monitor_.set_suspicions(std::span(all).first(in_.byte() % 5));
  }

  Reader& in_;
  int sensors_;
  FiringClock clock_;
  BeltMonitor monitor_;
  Clock host_;
  std::uint16_t seq_ = 0;
  double last_stamp_ = -1e300;
  double newest_arrival_ = -1e300;
};

}  // namespace

std::string belt(Bytes data) {
  Reader in(data);
  Belt belt(in);
  for (int i = 0; i < kMostCalls && !in.empty(); ++i) {
    if (std::string broken = belt.call(); !broken.empty()) return broken;
  }
  return "";
}

}  // namespace echoway::fuzz
