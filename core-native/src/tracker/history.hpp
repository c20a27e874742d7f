#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "tracker/motion.hpp"

namespace echoway::tracker {

/// A firing as the filter used it, kept so that a search can try other places on the same evidence.
struct Record {
  Interval interval{};       ///< Since the firing before.
  HintIntegrator::GaitEvidence gait{};   ///< What steps, or their absence, told of it.
  int sensor = 0;
  bool echo = false;
  double range = 0.0;
  double trust = 1.0;
  double novelty = 1.0;      ///< Share of the evidence that is new: a sensor that has not moved says the same again.
  double log_main = 0.0;     ///< Log density that the tracked hypothesis gave it,
  double log_second = 0.0;   ///< and the understudy; 0 without one.
};

/// The last kSize firings, by a running number.
class History {
 public:
  static constexpr std::uint64_t kSize = 2048;

  void push(const Record& record) noexcept { records_[next_++ % kSize] = record; }
  [[nodiscard]] std::uint64_t end() const noexcept { return next_; }
  [[nodiscard]] std::uint64_t begin() const noexcept { return next_ > kSize ? next_ - kSize : 0; }
  [[nodiscard]] const Record& operator[](std::uint64_t number) const noexcept { return records_[number % kSize]; }
  [[nodiscard]] Record& back() noexcept { return records_[(next_ - 1) % kSize]; }
  /// The tracked hypothesis and the understudy change places: from firing `first` on each has made of the echoes what
  /// the other one is said to have.
  void exchange(std::uint64_t first) noexcept {
    for (std::uint64_t n = std::max(first, begin()); n < next_; ++n) {
      std::swap(records_[n % kSize].log_main, records_[n % kSize].log_second);
    }
  }

 private:
  std::array<Record, kSize> records_{};
  std::uint64_t next_ = 0;
};

}  // namespace echoway::tracker
