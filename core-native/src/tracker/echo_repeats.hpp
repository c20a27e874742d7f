#pragma once

#include <array>
#include <span>

#include "echoway/belt/belt.hpp"
#include "echoway/geometry/pose2.hpp"

namespace echoway::tracker {

/// The echo of one sensor's last firing, as something that might answer again.
struct Repeat {
  int sensor = 0;           ///< Whose last echo it was.
  double density = 0.0;     ///< Of the range now measured, per metre, if whatever answered then answers now.
};

/// What answered a moment ago answers again: a cupboard stands where it stood, an arm swings at the same
/// distance, a rough wall keeps returning sound from beside the wearer. So a run of echoes from something that
/// is in no plan is one surprise, not many, and must not outweigh the true place by its number. The newest
/// echo of every sensor is kept in a frame that moves with the wearer; whether it came from the plan is each
/// particle's own opinion (Particle::strangers).
class EchoRepeats {
 public:
  static constexpr std::size_t kMost = 3;

  /// The wearer went `forward` metres and turned by `turn` radians.
  void move(double forward, double turn) noexcept;

  /// Echoes that may be repeated by one of `range` metres that `sensor` hears at `time_s`.
  [[nodiscard]] std::span<const Repeat> match(const BeltConfig& belt, int sensor, double range, double time_s) noexcept;
  void note(const BeltConfig& belt, int sensor, double range, double time_s) noexcept;

 private:
  struct Last {
    double time_s = -1e300;
    double range = 0.0;
    Vec2 at{};              ///< In the moving frame.
  };
  std::array<Last, kMaxSensors> last_{};
  std::array<Repeat, kMost> found_{};
  Pose2 pose_{};
};

}  // namespace echoway::tracker
