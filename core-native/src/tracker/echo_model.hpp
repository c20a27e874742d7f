#pragma once

#include <algorithm>
#include <array>

#include "echoway/belt/belt.hpp"
#include "scene/reflector.hpp"
#include "scene/scene.hpp"

namespace echoway::tracker {

/// What a firing returns, as far as the estimator believes. Probabilities per firing unless said otherwise. They
/// describe the Polaroid 6500 and furnished rooms in general and are tuned to no particular set of walks;
/// docs/tracker.md shows how flat the error is around them.
struct EchoModelParameters {
  double deaf = 0.12;                 ///< The whole firing is unheard: soft walls, clothes, a sensor turned up or down.
  double detect_wall = 0.96;          ///< Else a wall squarely in the beam answers.
  double detect_corner = 0.95;        ///< As strong as a wall (physics of Kuc and Siegel 1987).
  double fade_range_m = 9.0;          ///< Far walls and corners answer less: half as often at this distance,
  double fade_softness_m = 1.5;       ///< with this logistic width.
  double rough = 0.15;                ///< A wall that is met askew answers all the same: brick, books, curtains ...
  double rough_range_m = 3.0;         ///< ... up to this distance (thesis 6.2.5: near walls, at 30 to 60 degrees) ...
  double rough_angle_rad = degrees(60.0);   ///< ... and this angle.
  double detect_edge = 0.50;          ///< 37 dB weaker at 1 m: answers only near by ...
  double edge_half_range_m = 1.4;     ///< ... half as often at this distance ...
  double edge_softness_m = 0.4;       ///< ... with this logistic width.
  double detect_all_reflective = 0.70;
  double detect_mirrored = 0.55;      ///< Two bounces off a wall and a corner: weaker than the corner itself.
  double mirrored_range_m = 7.5;      ///< Half as often at this distance.
  double beam_reach = 1.12;           ///< Half-angle at which half of the walls answer, over the nominal one,
  double beam_softness = 0.18;        ///< and the logistic width of that edge, over the nominal one.
  double coarse_softness_rad = degrees(4.0);  ///< Added to it while headings are on a coarse grid.
  double range_floor_m = 0.012;       ///< Part of the range noise that does not grow with range: resolution, body sway.
  double clutter = 0.14;              ///< Something unmapped answers first ...
  double clutter_length_m = 2.5;      ///< ... at exponentially distributed ranges,
  double arm = 0.03;                  ///< or an arm or a hand,
  double arm_length_m = 0.25;         ///< much nearer still;
  double late = 0.10;                 ///< or the first echo of an unanswered firing comes by two or more reflections.
  double ghost = 0.02;                ///< A reading out of nowhere, uniform over the sensor's range.
  double furnished = 0.2;             ///< Something stands with its back to a wall that would answer, and does instead:
  double furniture_least_m = 0.25;    ///< a cupboard, a shelf or a sofa, at least so deep
  double furniture_most_m = 0.75;     ///< and at most,
  double furniture_softness_m = 0.10; ///< give or take so much.
};

/// The same for following a wearer whose place is known, who is heard among more than the plan knows of: one more thing
/// that stands in no plan must not drive out the right place.
[[nodiscard]] EchoModelParameters wary(EchoModelParameters parameters);
/// The same for a belt of weak sensors, or one worn under a coat, which hears what is near and nothing else.
[[nodiscard]] EchoModelParameters hard_of_hearing(EchoModelParameters parameters);
/// Echoes from beyond this distance, metres, such a belt does not hear.
inline constexpr double kHardOfHearingRange = 2.0;
/// What is nearer, metres, may be an arm, which goes with the wearer.
inline constexpr double kBeyondArms = 0.40;

/// The parameters for one belt, tabulated for the inner loop.
class EchoModel {
 public:
  EchoModel(const BeltConfig& belt, const EchoModelParameters& parameters);

  /// Probability that a reflector whose direction is off the beam's axis by an angle of this sine answers, before its
  /// kind and distance are considered. 0 at and beyond the cut-off.
  [[nodiscard]] double beam(double sine, bool coarse) const noexcept {
    const double at = sine * beam_scale_;
    const auto& table = coarse ? coarse_beam_ : fine_beam_;
    if (!(at < kBeamEntries - 1)) return 0.0;
    const auto i = static_cast<std::size_t>(at);
    const double f = at - static_cast<double>(i);
    return table[i] + f * (table[i + 1] - table[i]);
  }

  /// Squared sine of an angle at and beyond which beam() is 0, rounding included.
  [[nodiscard]] double outside_beam2(bool coarse) const noexcept {
    return coarse ? outside_coarse_beam2_ : outside_fine_beam2_;
  }

  /// Factor for kind and distance.
  [[nodiscard]] double reach(scene::ReflectorKind kind, double distance) const noexcept {
    const auto& table = reach_[static_cast<std::size_t>(kind)];
    const double at = distance * kReachPerMetre;
    return at < kReachEntries ? table[static_cast<std::size_t>(at)] : 0.0;
  }

  /// Density of echoes that the map does not explain, per metre at range `r`, given that nothing nearer answered.
  [[nodiscard]] double unexplained(double r) const noexcept {
    const double at = r * kReachPerMetre;
    return at < kReachEntries ? unexplained_[static_cast<std::size_t>(at)] : ghost_density_;
  }

  /// Probability that a wall answers that is `distance` away along an axis whose angle with the normal has this cosine.
  [[nodiscard]] double rough(double cosine, double distance) const noexcept {
    const bool answers = !too_askew(cosine) && distance < rough_range_;
    return answers ? rough_ * std::min(1.0, 2.0 * (1.0 - distance / rough_range_)) : 0.0;
  }
  /// At such an angle no rough wall answers.
  [[nodiscard]] bool too_askew(double cosine) const noexcept { return !(cosine > rough_cosine_); }

  /// Density of an echo at `range`, per metre: `explained` by the plan (chance times Gaussian, summed), by what is not
  /// in it behind what failed to answer (`survival`: chance that nothing nearer did), by `furniture` before a wall, or
  /// `again`, known to answer now.
  [[nodiscard]] double echo(double explained, double survival, double range, double furniture = 0.0,
                            double again = 0.0) const noexcept {
    return heard() * (quiet_ * explained + survival * unexplained(range) + furniture + again) + ghost_density_;
  }
  /// Density, per metre, of an echo so much `earlier`, metres, than that of a wall, from what stands with its back to
  /// it where the wall would answer. Most furniture stands so: an echo from half a metre before the end of a hall is
  /// hardly a surprise, and no reason to be half a metre farther on.
  [[nodiscard]] double furniture(double earlier) const noexcept {
    const double inside = std::min(earlier - furniture_begin_, furniture_end_ - earlier);
    return inside > 0.0 ? furniture_density_ * std::min(1.0, inside * furniture_slope_) : 0.0;
  }
  /// Probability of no echo where nothing in the plan answers with probability `survival`.
  [[nodiscard]] double silence(double survival) const noexcept { return deaf_ + heard() * quiet_ * survival; }
  /// Probability that the firing is heard at all.
  [[nodiscard]] double heard() const noexcept { return 1.0 - deaf_; }
  /// Probability that nothing unmapped answers either.
  [[nodiscard]] double quiet() const noexcept { return quiet_; }
  [[nodiscard]] double variance(double range) const noexcept {
    const double spread = noise_share_ * range;
    return floor2_ + spread * spread;
  }
  [[nodiscard]] double min_range() const noexcept { return min_range_; }
  [[nodiscard]] double half_beam_sine() const noexcept { return half_beam_sine_; }
  [[nodiscard]] double half_beam_cosine() const noexcept { return half_beam_cosine_; }
  [[nodiscard]] scene::SightLimits sight_limits() const noexcept { return limits_; }

 private:
  static constexpr std::size_t kBeamEntries = 257;
  static constexpr std::size_t kReachEntries = 600;
  static constexpr double kReachPerMetre = 50.0;

  std::array<double, kBeamEntries> fine_beam_{};
  std::array<double, kBeamEntries> coarse_beam_{};
  std::array<std::array<double, kReachEntries>, scene::kReflectorKinds> reach_{};
  std::array<double, kReachEntries> unexplained_{};
  double beam_scale_ = 0.0;
  double outside_fine_beam2_ = 1.0;
  double outside_coarse_beam2_ = 1.0;
  double ghost_density_ = 0.0;
  double furniture_density_ = 0.0;
  double furniture_begin_ = 0.0;
  double furniture_end_ = 0.0;
  double furniture_slope_ = 0.0;
  double quiet_ = 1.0;
  double deaf_ = 0.0;
  double noise_share_ = 0.0;
  double floor2_ = 0.0;
  double min_range_ = 0.0;
  double rough_ = 0.0;
  double rough_range_ = 0.0;
  double rough_cosine_ = 1.0;
  double half_beam_sine_ = 0.0;
  double half_beam_cosine_ = 1.0;
  scene::SightLimits limits_;
};

}  // namespace echoway::tracker
