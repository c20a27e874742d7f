#pragma once

#include <cstdint>

namespace echoway {

/// Puts the belt's firings on the host's clock.
///
/// Sentences reach the host late and in bursts (serial FIFOs, USB frames), but the belt fires on a regular beat and
/// numbers its firings. So a firing's time is a line through the sequence numbers that hugs the earliest arrivals:
/// delay only ever adds. The line's slope starts at the configured slot and follows the belt's real beat, measured
/// between the least delayed firings of successive blocks.
class FiringClock {
 public:
  /// `slot_s`: the expected time between two firings, > 0.
  explicit FiringClock(double slot_s);

  struct Stamp {
    double time_s = 0.0;       ///< On the host's clock; goes back only when that clock was set back, by 10 s or more.
    std::uint32_t lost = 0;    ///< Firings missing between this one and the one before.
    bool restarted = false;    ///< The sequence started over (the belt rebooted).
  };

  /// The time of firing `seq` (modulo 65536), whose sentence arrived at `arrival_s`.
  Stamp stamp(std::uint16_t seq, double arrival_s);

  /// Forgets the belt's beat and numbering (a port opened anew); times still do not go back.
  void reset();

 private:
  // The least delayed firing of a block of them.
  struct Earliest {
    double lateness = 0.0;   // behind the line
    double arrival = 0.0;
    std::int64_t index = 0;
    bool known = false;
  };

  void anchor(double arrival_s);
  void follow(double arrival_s);
  void end_block();

  double nominal_slot_;
  double slot_;
  bool started_ = false;
  std::uint16_t last_seq_ = 0;
  std::int64_t index_ = 0;         // firings since the sequence started, lost ones included
  std::int64_t block_start_ = 0;
  Earliest block_;
  Earliest previous_block_;
  double last_arrival_ = 0.0;
  double line_ = 0.0;              // where the line puts the newest firing
  double last_time_ = -1e300;
};

}  // namespace echoway
