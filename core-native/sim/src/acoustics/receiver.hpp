#pragma once

#include <optional>
#include <vector>

#include "echoway/geometry/vec2.hpp"
#include "echoway/sim/world.hpp"

namespace echoway::sim {

/// Sound that comes back: how long its path was and how strong it is.
struct Arrival {
  double path_m = 0.0;
  double amplitude = 0.0;    ///< Before the direction of arrival counts; relative to a plane 2 m off on the axis.
  double cos_arrival = 1.0;  ///< Of the angle between the transducer's axis and the direction it comes from,
  Vec2 from{1.0, 0.0};       ///< which is this, a unit vector.
};

/// The transducer's directivity and the ranging module: gain that rises with time, a threshold, a finite rise time.
class Receiver {
 public:
  explicit Receiver(const World& world);

  /// One-way directivity at an angle off the axis, signed (side lobes alternate), 0 behind.
  [[nodiscard]] double directivity(double cos_theta) const noexcept;

  /// The angle off the axis at which the main lobe ends, radians; a right angle for a disc too small to have a null.
  [[nodiscard]] double first_null() const noexcept;

  /// Spreading and absorption over a mirror-like path, 1 for a plane 2 m off.
  [[nodiscard]] double path_amplitude(double path_m) const noexcept;

  /// Extra loss of an edge (radius 0) or a thin post seen from `distance_m`, against a plane there. Edge: Kuc and
  /// Siegel, (2 pi sqrt(z / lambda))^-1; post: the mirror image behind a cylinder, sqrt(f / (z + f)) with f half its
  /// radius.
  [[nodiscard]] double scatter_loss(double distance_m, double radius_m) const noexcept;

  /// Part of a plane's echo left when its reflection point lies `inside_m` inside its end (negative: beyond it): half
  /// at the end, as in Fresnel's knife edge, all or nothing a Fresnel zone away.
  [[nodiscard]] double end_taper(double inside_m, double path_m) const noexcept;

  /// Amplitude over threshold at the time the echo arrives; an echo below 1 goes unnoticed.
  [[nodiscard]] double over_threshold(double path_m, double received) const noexcept;

  /// The path length at which the sum of all arrivals first crosses the threshold, the mean delay of a strong echo
  /// calibrated out; nothing when none does. A weak echo crosses later in its rise.
  [[nodiscard]] std::optional<double> first_crossing(std::vector<Arrival>& arrivals) const;

  /// Steady interference of the given level, over threshold at 2 m: the path length at which the rising gain lifts it
  /// over the threshold.
  [[nodiscard]] std::optional<double> interference_crossing(double level) const noexcept;

  /// Up to how far off its normal a plane wall at `distance_m` answers without a gap, radians.
  [[nodiscard]] double plane_half_angle(double distance_m) const;

 private:
  [[nodiscard]] double gain(double path_m) const noexcept;

  std::vector<double> pattern_;  // Directivity, evenly spaced in the sine of the angle off the axis.
  double wave_number_;
  double wavelength_;
  double radius_;
  double absorption_;  // Nepers per metre.
  double sound_speed_;
  double margin_;  // Amplitude ratio.
};

/// The disc that, in `world`, makes a plane wall 2 m off answer up to `half_angle` from its normal, metres.
[[nodiscard]] double transducer_radius_for(double half_angle, const World& world);

}  // namespace echoway::sim
