#pragma once

#include <cstdint>
#include <memory>

#include "echoway/locate/locator.hpp"

namespace echoway {

struct BayesOptions {
  std::uint64_t seed = 1;
  /// Particles while the wearer's place is known, with and without a gyroscope. The tracker takes more by itself while the
  /// place is uncertain.
  int particles = 240;
  int particles_without_gyroscope = 800;
};

/// The default method: a Rao-Blackwellised particle filter over room, position, heading, speed and sound-speed scale for
/// the whole building, renewed at every firing (docs/tracker.md). Starts from a pose, a room or nothing; notices that it
/// is wrong and searches the building again.
class BayesLocator final : public Locator {
 public:
  /// Keeps a reference to `building`, which must outlive the locator. All memory is reserved here.
  BayesLocator(const Building& building, const BeltConfig& belt, const Start& start, const BayesOptions& options = {});
  ~BayesLocator() override;

  bool on_firing(const Firing& firing) override;
  void on_motion(const MotionHint& hint) override;
  void on_temperature(double celsius) override;
  [[nodiscard]] const Estimate& estimate() const override;
  [[nodiscard]] std::span<const Hypothesis> hypotheses() const override;
  [[nodiscard]] std::span<const SensorSuspicion> suspicions() const override;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace echoway
