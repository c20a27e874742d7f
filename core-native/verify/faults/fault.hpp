#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "echoway/sim/simulate.hpp"

/// Faults between belt and core, injected into the bytes of a simulated walk. One table serves the tests and the page
/// docs/faults.md.
namespace echoway::faults {

/// Something that reaches the core from outside, at a time on the host's clock.
struct Event {
  enum class Kind : std::uint8_t { bytes, attached, detached } kind = Kind::bytes;
  double time_s = 0.0;
  std::vector<std::uint8_t> bytes = {};
};
using Events = std::vector<Event>;

/// The fault begins and ends here, seconds into the walk, where it does not last throughout.
inline constexpr double kBegin = 15.0;
inline constexpr double kEnd = 25.0;

/// What the wearer must hear of it.
enum class Expect : std::uint8_t {
  nothing,         ///< It must not reach the wearer.
  belt_lost,       ///< "Belt disconnected." within 2 s of its beginning.
  sensor_blocked,  ///< Which sensor, within 10 s of its beginning: as many rounds tell a cover from an arm.
  anything,        ///< So little arrives that no line would be wrong; promises must hold all the same.
};

struct Fault {
  std::string name;
  Expect expect = Expect::nothing;
  std::function<void(Events&)> inject;
  double allowed_error_m = 1.0;       ///< Of the last estimate, long after the fault.
  bool corrupts = false;              ///< Bytes are damaged on the way: what arrives must be what was sent.
};

struct Line {
  std::string words;
  double after_s = 0.0;               ///< Since kBegin.
};

struct Report {
  std::string broken;                 ///< First broken promise of the session's output; empty when all were kept.
  std::vector<Line> heard;
  int sent = 0;                       ///< Firings of the belt,
  int taken = 0;                      ///< of them decoded,
  int invented = 0;                   ///< and decoded though the belt never sent them.
  double error_m = 0.0;               ///< Of the last estimate.
};

/// Every fault.
[[nodiscard]] const std::vector<Fault>& table();
/// Sends the walk's bytes, with the fault in them, through a session.
[[nodiscard]] Report run(const Fault& fault);
/// Why a result is not what the fault should come to; empty when it is.
[[nodiscard]] std::string verdict(const Fault& fault, const Report& result);
/// docs/faults.md.
[[nodiscard]] std::string page();

/// The walk that the faults are injected into: a minute through three rooms.
[[nodiscard]] const sim::Simulation& walk();
/// The sentences that a belt sends during a walk, one event each, 5 ms after the firing.
[[nodiscard]] Events sentences_of(const sim::Simulation& walk);
/// Sentences that a decoder hands on although nobody sent them: what a checksum lets through.
[[nodiscard]] int invented(const Events& events, const Events& sent);

// What can happen to bytes, each n-th of all.
void lose_each(Events& events, int n);
void double_each(Events& events, int n);
void flip_each(Events& events, int n);

}  // namespace echoway::faults
