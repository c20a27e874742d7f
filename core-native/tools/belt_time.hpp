#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace echoway::tools {

/// When a live belt's sentences arrived, on a clock that goes with the host's and keeps to what the belt has done.
///
/// The wire tells no time, but a belt fires once a beat and numbers its firings. Sentences that come far faster than any
/// belt fires were held up, or are a recording that nobody paces: they are a beat apart each, from where the last one was, and
/// the clock goes on from there.
class BeltTime {
 public:
  /// `slot_s`: the expected time between two firings, > 0.
  explicit BeltTime(double slot_s) : slot_(slot_s) {}

  /// That moment of the host's clock, seconds since the start. Nothing arrives before it any more.
  [[nodiscard]] double tell(double host_s) { return told_ = std::max(told_, host_s + ahead_); }

  /// So many sentences were read at once.
  void on_read(std::size_t sentences, double host_s);
  /// When the next of them arrived.
  [[nodiscard]] double next() const { return std::max(told_, pressed_ ? last_ + slot_ : read_at_ + ahead_); }
  /// It was one of `firings`, before which others were lost, and has been dealt with.
  void on_firings(int firings, std::uint64_t lost, double host_s);

 private:
  double slot_;
  double read_at_ = 0.0;   // by the host's clock
  double ahead_ = 0.0;     // of the host's clock; behind it when negative
  double told_ = 0.0;
  double last_ = 0.0;      // when the newest firing arrived
  double pressure_ = 0.0;  // sentences beyond what the fastest belt can have sent
  bool pressed_ = false;
};

}  // namespace echoway::tools
