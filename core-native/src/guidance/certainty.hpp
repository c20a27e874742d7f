#pragma once

#include <cstdint>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"

namespace echoway::guidance {

/// How far an estimate may be trusted, with hysteresis.
class Certainty {
 public:
  enum class Level : std::uint8_t { lost, vague, sure };

  explicit Certainty(const GuideConfig& config) : config_(&config) {}

  /// Takes a new estimate in. `suspended`: echoes need not fit now (stairs), so a loss is not counted.
  void update(const Estimate& estimate, bool suspended) noexcept;

  [[nodiscard]] Level level() const noexcept { return level_; }
  /// True for a moment after the place has jumped as nobody walks: it was wrong before, or is now.
  [[nodiscard]] bool jumped(double now) const noexcept { return now - jumped_s_ < config_->settle_s; }
  /// Whether the last estimate alone says that the place is known.
  [[nodiscard]] bool fits_now() const noexcept { return fits_now_; }
  /// Whether it has ever been sure of a place.
  [[nodiscard]] bool was_sure() const noexcept { return was_sure_; }

 private:
  [[nodiscard]] bool place_jumps(const Estimate& estimate) noexcept;

  const GuideConfig* config_;
  Estimate last_{};
  double jumped_s_ = -1e300;
  Level level_ = Level::lost;
  bool was_sure_ = false;
  bool fits_now_ = false;
  double doubt_ = 1.0;           ///< How much longer than usual a place must fit to be believed.
  double found_at_ = -1e300;
  bool started_ = false;
  double changing_since_ = 0.0;  ///< Since when the estimate says something other than level_.
};

}  // namespace echoway::guidance
