#pragma once

namespace echoway::tracker {

/// Watches whether the tracked place keeps explaining the echoes better than no place at all would.
class FitMonitor {
 public:
  /// Density of a reading, per metre for an echo and a plain probability for none, when nothing is known of the place.
  [[nodiscard]] double anywhere(bool echo, double range) const noexcept;
  /// Share of the firings observed of late that were answered. 0.15 to 0.85.
  [[nodiscard]] double echo_share() const noexcept { return echo_share_; }

  /// By how much `log_density`, which a place gave a reading, is above that of nothing known: log likelihood, -4 to 4.
  [[nodiscard]] double gain(double log_density, bool echo, double range) const noexcept;
  /// `log_density` as the tracked hypothesis predicted the reading; `echo` and `range` say which reading it was.
  void observe(double log_density, bool echo, double range) noexcept;
  void reset() noexcept;

  /// Mean log-likelihood gain per firing over the reference, over about two and about twenty seconds.
  [[nodiscard]] double recent() const noexcept { return short_; }
  [[nodiscard]] double usual() const noexcept { return long_; }
  /// The echoes do not fit where we think the wearer is.
  [[nodiscard]] bool poor() const noexcept;
  /// They fit less well than they used to.
  [[nodiscard]] bool doubtful() const noexcept;
  /// How many times more particles than usual the belief deserves: 1 when the last second fits, up to 4 when not.
  [[nodiscard]] double doubt() const noexcept;

 private:
  double echo_share_ = 0.45;
  double shortest_ = 0.5;
  double short_ = 0.5;
  double long_ = 0.5;
  int observed_ = 0;
};

}  // namespace echoway::tracker
