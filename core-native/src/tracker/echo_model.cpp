#include "tracker/echo_model.hpp"

#include <algorithm>
#include <cmath>

#include "tracker/elementary.hpp"

namespace echoway::tracker {
namespace {

double logistic(double x) noexcept { return 1.0 / (1.0 + fast_exp(-x)); }

constexpr double kLogisticTail = 4.5;       // Widths beyond which the beam's edge is taken as over (1.1 %).
constexpr double kRounding = 1e-12;         // Far more than sines of the same angle may differ by, however computed.
constexpr double kLeastEdgeChance = 0.01;   // An edge that answers less often than this never wins.

}  // namespace

EchoModelParameters hard_of_hearing(EchoModelParameters parameters) {
  parameters.fade_range_m = 1.3;
  parameters.fade_softness_m = 0.15;
  parameters.mirrored_range_m = 1.2;
  return parameters;
}

EchoModelParameters wary(EchoModelParameters parameters) {
  parameters.deaf = 0.20;
  parameters.clutter = 0.25;
  parameters.arm = 0.08;
  parameters.ghost = 0.04;
  parameters.furnished *= 2.0;
  return parameters;
}

EchoModel::EchoModel(const BeltConfig& belt, const EchoModelParameters& p) {
  const double nominal = 0.5 * std::clamp(belt.beam_rad, degrees(2.0), degrees(120.0));
  const double half = p.beam_reach * nominal;
  const double fine_width = p.beam_softness * nominal;
  const double coarse_width = fine_width + p.coarse_softness_rad;
  const double cut_off = std::min(half + kLogisticTail * fine_width + 1.5 * p.coarse_softness_rad, degrees(85.0));
  half_beam_sine_ = std::sin(half);
  half_beam_cosine_ = std::cos(half);
  beam_scale_ = (kBeamEntries - 1) / std::sin(cut_off);
  for (std::size_t i = 0; i < kBeamEntries - 1; ++i) {
    const double angle = std::asin(static_cast<double>(i) / beam_scale_);
    const double fine = (half - angle) / fine_width;
    fine_beam_[i] = fine < -kLogisticTail ? 0.0 : logistic(fine);
    coarse_beam_[i] = logistic((half - angle) / coarse_width);
  }
  std::size_t silent = kBeamEntries - 1;
  while (silent > 0 && fine_beam_[silent - 1] == 0.0) --silent;
  const double beyond = std::sin(cut_off) * (1.0 + kRounding);
  const double beyond_fine = static_cast<double>(silent) / beam_scale_ * (1.0 + kRounding);
  outside_coarse_beam2_ = beyond * beyond;
  outside_fine_beam2_ = beyond_fine * beyond_fine;

  const double span = std::max(0.1, belt.max_range_m - belt.min_range_m);
  ghost_density_ = p.ghost / span;
  for (std::size_t i = 0; i < kReachEntries; ++i) {
    const double d = (static_cast<double>(i) + 0.5) / kReachPerMetre;
    const bool blanked = d < 0.8 * belt.min_range_m || d > belt.max_range_m + 0.25;
    const double in_range = blanked ? 0.0 : logistic((belt.max_range_m - 0.15 - d) / 0.1);
    reach_[static_cast<std::size_t>(scene::ReflectorKind::wall)][i] =
        p.detect_wall * in_range * logistic((p.fade_range_m - d) / p.fade_softness_m);
    reach_[static_cast<std::size_t>(scene::ReflectorKind::corner)][i] =
        p.detect_corner * in_range * logistic((p.fade_range_m - d) / p.fade_softness_m);
    reach_[static_cast<std::size_t>(scene::ReflectorKind::mirrored_corner)][i] =
        p.detect_mirrored * in_range * logistic((p.mirrored_range_m - d) / p.fade_softness_m);
    const double edge = p.detect_edge * logistic((p.edge_half_range_m - d) / p.edge_softness_m) * in_range;
    reach_[static_cast<std::size_t>(scene::ReflectorKind::edge)][i] = edge < kLeastEdgeChance ? 0.0 : edge;
    if (edge >= kLeastEdgeChance) limits_.max_edge_range = d;
    reach_[static_cast<std::size_t>(scene::ReflectorKind::all_reflective)][i] =
        p.detect_all_reflective * in_range * logistic((p.fade_range_m - d) / p.fade_softness_m);
    unexplained_[i] = ghost_density_ + p.clutter / p.clutter_length_m * fast_exp(-d / p.clutter_length_m) +
                      p.arm / p.arm_length_m * fast_exp(-d / p.arm_length_m) + p.late / span;
  }
  furniture_density_ = p.furnished / (p.furniture_most_m - p.furniture_least_m);
  furniture_begin_ = p.furniture_least_m - p.furniture_softness_m;
  furniture_end_ = p.furniture_most_m + p.furniture_softness_m;
  furniture_slope_ = 0.5 / p.furniture_softness_m;
  quiet_ = 1.0 - p.clutter - p.arm - p.late - p.ghost;
  deaf_ = p.deaf;
  noise_share_ = belt.range_noise;
  floor2_ = p.range_floor_m * p.range_floor_m;
  min_range_ = belt.min_range_m;
  limits_.max_range = belt.max_range_m + 0.3;
  limits_.max_mirrored_range = limits_.max_range;
  limits_.max_edge_range += 0.02;
  limits_.all_reflective_cut_off_rad = half;
  limits_.sharp_cut_off_rad = std::asin(std::min(1.0, beyond_fine));
  limits_.cut_off_rad = cut_off;
  rough_ = p.rough;
  rough_range_ = p.rough_range_m;
  rough_cosine_ = std::cos(p.rough_angle_rad);
  limits_.rough_range = p.rough > 0.0 ? p.rough_range_m : 0.0;
  limits_.rough_cut_off_rad = p.rough_angle_rad;
}

}  // namespace echoway::tracker
