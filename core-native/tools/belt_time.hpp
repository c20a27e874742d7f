#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace echoway::tools {

/// When a live belt's sentences arrived: a clock that runs with the host's and, in a rush of sentences, with the belt's
/// beat.
///
/// The wire tells no time, but a belt fires once a beat and numbers its firings. Sentences that come far faster than
/// any belt fires were held up, or are a recording sent without pauses: they count as one beat apart, from the last one
/// before them, and the clock runs on from there. All times are seconds since the start.
class BeltTime {
 public:
  /// `slot_s`: the expected time between two firings, > 0.
  explicit BeltTime(double slot_s) : slot_(slot_s) {}

  /// What this clock shows when the host's shows `host_s`. Nothing arrives before it any more.
  [[nodiscard]] double tell(double host_s) { return told_ = std::max(told_, host_s + ahead_); }

  /// So many sentences were read at once; next() and on_firings() follow for each.
  void on_read(std::size_t sentences, double host_s);
  /// When the next of them arrived.
  [[nodiscard]] double next() const { return std::max(told_, pressed_ ? last_ + slot_ : read_at_ + ahead_); }
  /// It held so many firings (0: it was of another kind), before which others were lost.
  void on_firings(int firings, std::uint64_t lost, double host_s);

 private:
  double slot_;
  double read_at_ = 0.0;   // by the host's clock
  double ahead_ = 0.0;     // of the host's clock; behind it when negative
  double told_ = 0.0;      // the latest time that was given out
  double last_ = 0.0;      // when the newest firing arrived
  double pressure_ = 0.0;  // sentences beyond what the fastest belt can have sent
  bool pressed_ = false;
};

}  // namespace echoway::tools
