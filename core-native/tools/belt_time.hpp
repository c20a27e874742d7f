#pragma once

#include <cstddef>
#include <cstdint>

namespace echoway::tools {

/// When a live belt's sentences arrived, on a clock that goes with the host's and is never behind what the belt has done.
///
/// The wire tells no time, but a belt fires once a beat and numbers its firings. Sentences that come far faster than any
/// belt fires were held up, or are a recording that nobody paces: they are a beat apart each, from where the last one was.
/// Where that leads past the host's clock, this one runs ahead of it from then on.
class BeltTime {
 public:
  /// `slot_s`: the expected time between two firings, > 0.
  explicit BeltTime(double slot_s) : slot_(slot_s) {}

  /// That moment of the host's clock, seconds since the start.
  [[nodiscard]] double at(double host_s) const { return host_s + ahead_; }

  /// So many sentences were read at once.
  void on_read(std::size_t sentences, double host_s);
  /// When the next of them arrived.
  [[nodiscard]] double next() const { return pressed_ ? last_ + slot_ : now_; }
  /// It was one of `firings`, before which others were lost.
  void on_firings(int firings, std::uint64_t lost);

 private:
  double slot_;
  double read_at_ = 0.0;   // by the host's clock
  double now_ = 0.0;       // the same moment on this one
  double ahead_ = 0.0;
  double last_ = 0.0;      // when the newest firing arrived
  double pressure_ = 0.0;  // sentences beyond what the fastest belt can have sent
  bool pressed_ = false;
};

}  // namespace echoway::tools
