#pragma once

#include <cstdint>
#include <memory>

#include "echoway/locate/locator.hpp"

namespace echoway {

/// The tracker's parts. All of them belong to it; the report switches one off at a time to show what it buys.
struct TrackerParts {
  bool silence = true;           ///< A missing echo is evidence.
  bool rough_walls = true;       ///< Near walls may answer askew.
  bool mirrored_corners = true;  ///< Corners are heard by way of walls.
  bool furniture = true;         ///< What is in no plan stands with its back to walls, and is known there again.
  bool repeats = true;           ///< What answered a moment ago answers again.
  bool range_rate = true;        ///< With a gyroscope, what stands in no plan tells how fast the wearer comes nearer.
  bool memory = true;            ///< Unmapped furniture is remembered.
  bool novelty = true;           ///< A resting sensor's evidence counts once.
  bool sound_speed = true;       ///< The scale of ranges is estimated.
  bool modes = true;             ///< Places that lie apart are followed for as long as they are possible.
  bool recovery = true;          ///< Other places are searched when the echoes fit badly.
  bool probation = true;         ///< What was found must prove itself before it is believed.
  bool understudy = true;        ///< Without a gyroscope half of the particles that track a place are a second belief.
};

struct BayesOptions {
  std::uint64_t seed = 1;
  /// Particles while the wearer's place is known, with and without a gyroscope, where half of them are a second belief.
  /// The tracker takes more by itself for one who walks fast and while the place is uncertain.
  int particles = 80;
  int particles_without_gyroscope = 800;
  TrackerParts parts{};
};

/// The default method: a Rao-Blackwellised particle filter over room, position, heading, speed and sound-speed scale
/// for the whole building, renewed at every firing (docs/tracker.md). Starts from a pose, a room or nothing; notices
/// that it is wrong and searches the building again.
class BayesLocator final : public Locator {
 public:
  /// Keeps a reference to `building`, which must outlive the locator. All memory is reserved here.
  BayesLocator(const Building& building, const BeltConfig& belt, const Start& start, const BayesOptions& options = {});
  ~BayesLocator() override;

  bool on_firing(const Firing& firing) override;
  void on_motion(const MotionHint& hint) override;
  void on_temperature(double celsius) override;
  void on_level_transition(const LevelTransition& transition) override;
  void on_led(bool led) override;
  void on_doubt() override;
  [[nodiscard]] const Estimate& estimate() const override;
  [[nodiscard]] std::span<const Hypothesis> hypotheses() const override;
  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const override;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace echoway
