#pragma once

#include <optional>
#include <vector>

#include "echoway/sim/world.hpp"

namespace echoway::sim {

/// Sound that comes back: how long its path was and how strong it is, relative to what a plane 2 m off returns on the
/// axis.
struct Arrival {
  double path_m = 0.0;
  double amplitude = 0.0;
};

/// The transducer's directivity and the ranging module: gain that rises with time, a threshold, a finite rise time.
class Receiver {
 public:
  explicit Receiver(const World& world);

  /// Two-way amplitude, relative to a plane 2 m off on the axis, of a mirror-like path of the given length that leaves
  /// and arrives at the given angles off the axis.
  [[nodiscard]] double mirror_amplitude(double path_m, double cos_out, double cos_in) const noexcept;

  /// Extra loss of an edge or a thin post (radius > 0) seen from `distance_m`, against a plane there.
  [[nodiscard]] double scatter_loss(double distance_m, double radius_m) const noexcept;

  /// Part of a plane's echo left when its reflection point lies `inside_m` inside its end (negative: beyond it).
  [[nodiscard]] double end_taper(double inside_m, double path_m) const noexcept;

  /// Amplitude over threshold at the time the echo arrives; an echo below 1 goes unnoticed.
  [[nodiscard]] double over_threshold(const Arrival& arrival) const noexcept;

  /// Smallest amplitude that anything can have and be noticed: used to leave out what cannot matter.
  [[nodiscard]] double least_amplitude() const noexcept { return least_; }

  /// The path length at which the first noticed echo crosses the threshold, the mean delay of a strong echo calibrated
  /// out; nothing when all are too weak.
  [[nodiscard]] std::optional<double> first_crossing(const std::vector<Arrival>& arrivals) const;

  /// What a plane wall at `distance_m` answers up to, radians off its normal.
  [[nodiscard]] double plane_half_angle(double distance_m) const;

 private:
  [[nodiscard]] double gain(double path_m) const noexcept;

  double wave_number_;
  double wavelength_;
  double radius_;
  double absorption_;      // Nepers per metre.
  double sound_speed_;
  double margin_;          // Amplitude ratio.
  double least_;
};

}  // namespace echoway::sim
