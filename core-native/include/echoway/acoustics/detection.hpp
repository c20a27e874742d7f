#pragma once

#include <vector>

#include "echoway/acoustics/echo_waveform.hpp"
#include "echoway/belt/belt.hpp"

namespace echoway {

/// What fixes the sensitivity of the simulated ranging module beyond what the belt's description says.
struct DetectionParameters {
  /// An edge straight ahead answers up to here, metres, > 0. It sets the threshold: with the diffraction factor's 42 dB
  /// at 3 m, a wall straight ahead is 42 dB above it.
  double edge_reach_m = 3.0;
  double full_gain_s = 0.038;  ///< Thesis section 6.1.
};

/// How far off its axis a sensor still hears each kind of element, by distance: the waveform model against the
/// receiver's threshold, once per belt, as a table for the inner loop.
///
/// The belt says within which angle a plane wall answers (BeltConfig::beam_rad). The aperture that the model works with
/// is the one for which the plane's echo has fallen to the threshold at that angle, so a belt of wide-beam sensors gets
/// a small piston; it need not equal the transducer's true radius. Corners answer like walls; edges, weaker by the
/// diffraction factor, within a narrower angle that closes at `edge_reach_m`; all-reflective elements anywhere in the
/// beam.
class DetectionTable {
 public:
  explicit DetectionTable(const BeltConfig& belt, const DetectionParameters& parameters = {});

  /// Half-angle of detection at a face-to-element distance, radians; negative when nothing of this kind is heard there.
  [[nodiscard]] double half_angle(ElementKind kind, double distance_m) const noexcept;

  /// Its cosine, for comparing with a dot product; 2 (never reached) where half_angle() is negative. Interpolated
  /// linearly between distances of max_range / 256.
  [[nodiscard]] double cos_half_angle(ElementKind kind, double distance_m) const noexcept {
    if (kind == ElementKind::reflector) return cos_widest_;
    const auto& table = kind == ElementKind::edge ? edge_ : plane_;
    const double cell = distance_m * cells_per_metre_;
    if (!(cell < kCells)) return table.back();
    const auto k = static_cast<std::size_t>(cell > 0.0 ? cell : 0.0);
    const double share = cell - static_cast<double>(k);
    return table[k] + share * (table[k + 1] - table[k]);
  }

  /// The distance beyond which this kind is never heard, metres, to within a cell of the table; at most max_range.
  [[nodiscard]] double reach(ElementKind kind) const noexcept;

  /// The widest half-angle of all, radians, at most 90 degrees.
  [[nodiscard]] double widest() const noexcept { return widest_; }
  /// The piston that the table was computed with.
  [[nodiscard]] const Transducer& transducer() const noexcept { return transducer_; }
  /// The receiver that the table was computed with.
  [[nodiscard]] const Receiver& receiver() const noexcept { return receiver_; }

 private:
  static constexpr double kCells = 256.0;

  Transducer transducer_;
  Receiver receiver_;
  double widest_ = 0.0;
  double cos_widest_ = 1.0;
  double cells_per_metre_ = 0.0;
  std::vector<double> plane_;  ///< Cosine of the half-angle at k / cells_per_metre_.
  std::vector<double> edge_;
};

}  // namespace echoway
