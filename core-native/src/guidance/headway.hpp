#pragma once

namespace echoway::guidance {

/// Whether a wearer who does as they are told gets any nearer to where they are going. Who does not, though the plan
/// has a way, is likely to be elsewhere: before a wall where the door should be, or in a room that looks the same.
class Headway {
 public:
  /// `cost`: of the way that is left. `instructed_s`: when an instruction was told last. True once each time they have
  /// not got nearer for long: the place is worth a doubt then.
  [[nodiscard]] bool update(double now, double cost, double instructed_s) noexcept;
  /// The place is doubted already: how near they have come is counted from here.
  void start_over() noexcept { count_from(cost_); }
  /// The wearer is bound for something else, or has started over.
  void forget() noexcept { *this = {}; }

 private:
  void count_from(double cost) noexcept;

  double least_ = 1e300;        ///< Cost of what was left when they were nearest.
  double cost_ = 1e300;         ///< Of what was left at the last update.
  double led_s_ = 0.0;          ///< Seconds of being led since then,
  int told_ = 0;                ///< instructions meanwhile.
  double last_told_ = -1e300;
  double last_ = -1e300;        ///< Time of the last update.
};

}  // namespace echoway::guidance
