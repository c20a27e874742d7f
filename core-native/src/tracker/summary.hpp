#pragma once

#include <array>
#include <span>

#include "echoway/building/building.hpp"
#include "echoway/locate/estimate.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// Moments of the particles that lie together, and of the clusters that lie apart.
struct Summary {
  static constexpr int kMaxClusters = 12;
  int count = 0;                                  ///< Most probable first.
  std::array<Hypothesis, kMaxClusters> hypotheses;
  Estimate best;                                  ///< Of the most probable cluster; state and time are the caller's.
  double log_scale = 0.0;
  double log_scale_sigma = 0.0;
  double gyro_bias = 0.0;
  double turn_rate = 0.0;                         ///< rad/s, as guessed without a gyroscope: mean of the particles,
  double turning = 0.0;                           ///< and mean of how fast they turn either way.
  double walking = 0.0;                           ///< Share that walks,
  double pace = 0.0;                              ///< and how fast.
};

struct SummaryParameters {
  double cluster_radius = 1.2;                    ///< Metres from a cluster's heaviest particle,
  double cluster_angle = degrees(60.0);           ///< and its heading.
  double sigma_factor = 1.25;                     ///< Correlated errors (furniture, body) make the filter's own sigma
  double sigma_floor = 0.02;                      ///< too small; calibrated over many walks, docs/tracker.md.
};

/// Groups weighted particles (weights add up to 1) and reports the heaviest group.
[[nodiscard]] Summary summarize(std::span<const Particle> particles, const Building& building,
                                const SummaryParameters& parameters) noexcept;

}  // namespace echoway::tracker
