#pragma once

#include <cstdint>

#include "echoway/guidance/guide_config.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/router.hpp"

namespace echoway::guidance {

/// How far an estimate may be trusted, with hysteresis.
class Certainty {
 public:
  enum class Level : std::uint8_t { lost, vague, sure };

  /// `facing_told`: a place that is known from the first estimate on was told with the way that the wearer faces. Who
  /// said where they stand alone may be known as soon, from a first echo that happens to fit one way to face.
  Certainty(const Router& router, const GuideConfig& config, bool facing_told)
      : router_(&router), config_(&config), facing_told_(facing_told) {}

  /// Takes a new estimate in. `suspended`: echoes need not fit now (stairs), so a loss is not counted.
  void update(const Estimate& estimate, bool suspended) noexcept;

  /// The place cannot be right, whatever the echoes say: what is found next is believed only once it has stood a turn.
  void reject(double now) noexcept;

  [[nodiscard]] Level level() const noexcept { return level_; }
  /// True for a moment after the place has jumped as nobody walks or turns: it was wrong before, or is now.
  [[nodiscard]] bool jumped(double now) const noexcept { return now - jumped_s_ < config_->settle_s; }
  /// Whether the last estimate alone says that the place is known.
  [[nodiscard]] bool fits_now() const noexcept { return fits_now_; }
  /// Whether somebody said where the wearer starts and which way they face, and that was known from the first estimate
  /// on.
  [[nodiscard]] bool was_told() const noexcept { return told_; }
  /// Whether the wearer has not left the room where the tracker found them by itself: they may be in another that looks
  /// the same.
  [[nodiscard]] bool is_unproven() const noexcept { return !told_ && last_.room == found_in_; }
  /// Whether it has ever been sure of a place.
  [[nodiscard]] bool was_sure() const noexcept { return was_sure_; }

 private:
  [[nodiscard]] double heading_of(const Estimate& estimate) const noexcept;
  [[nodiscard]] bool follow(const Estimate& estimate) noexcept;
  [[nodiscard]] bool is_within_walk(const Estimate& estimate) const noexcept;
  [[nodiscard]] bool has_moved_away(const Estimate& estimate, bool suspended) noexcept;
  [[nodiscard]] bool holds_though_unfit(const Estimate& estimate) const noexcept;
  [[nodiscard]] bool is_narrow(const Estimate& estimate) const noexcept;
  void set_home(const Estimate& estimate) noexcept;
  void become(Level level, double now) noexcept;

  const Router* router_;
  const GuideConfig* config_;
  bool facing_told_;
  Estimate last_{};
  Estimate home_{};              ///< Where the wearer was when the place was last believed.
  double jumped_s_ = -1e300;
  double away_since_ = -1.0;     ///< Since when the place is none that can be walked to from there; negative: it can.
  double walked_ = 0.0;          ///< Metres since `home_`,
  double turned_ = 0.0;          ///< and radians, left is positive.
  double proof_ = 0.0;           ///< Radians turned to either side since the place was lost or has jumped.
  Level level_ = Level::lost;
  RoomIndex found_in_ = kNoRoom; ///< Where the wearer was found last, after nobody knew the place.
  bool was_sure_ = false;
  bool told_ = false;
  bool fits_now_ = false;
  double doubt_ = 1.0;           ///< How much longer than usual a place must fit to be believed.
  double found_at_ = -1e300;
  bool started_ = false;
  double changing_since_ = 0.0;  ///< Since when the estimate says something other than level_.
};

}  // namespace echoway::guidance
