#include "echoway/acoustics/detection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace echoway {
namespace {

constexpr double kNever = 2.0;
constexpr double kSmallestHalfBeam = degrees(0.05);
constexpr double kFirstNull = 3.8317059702075123;  // of 2 J1(x)/x
constexpr int kSamplesPerCycle = 16;
constexpr double kFarthest = 50.0;  // metres; keeps the table's cells small whatever a belt claims

// Peak of the echo's envelope over that of the same echo met head-on; depends on the inclination alone.
double relative_peak(const Transducer& transducer, double inclination) {
  const double period = 1.0 / (kSamplesPerCycle * transducer.frequency_hz);
  // At 0.5 m the amplitude 1/(2z) is 1.
  return echo_waveform(transducer, ElementKind::wall, 0.5, inclination, period).peak();
}

// The radius for which the relative peak at `inclination` is `level`: it falls monotonically from cos^2 at radius 0 to
// next to nothing at the first null.
double aperture_for(Transducer transducer, double inclination, double level) {
  double low = 0.0;
  double high = kFirstNull / (transducer.wavenumber() * std::sin(inclination));
  for (int i = 0; i < 48; ++i) {
    transducer.radius_m = 0.5 * (low + high);
    (relative_peak(transducer, inclination) > level ? low : high) = transducer.radius_m;
  }
  return low;
}

// The fall of the relative peak over [0, widest], and its inverse.
class MainLobe {
 public:
  MainLobe(const Transducer& transducer, double widest) : widest_(widest) {
    const double head_on = relative_peak(transducer, 0.0);
    for (std::size_t i = 0; i < level_.size(); ++i) {
      const double level = relative_peak(transducer, angle(i)) / head_on;
      level_[i] = i == 0 ? 1.0 : std::min(level, level_[i - 1]);
    }
  }

  // Largest angle at which the level is still reached; negative when it is not even head-on.
  [[nodiscard]] double reach(double level) const noexcept {
    if (!(level <= 1.0)) return -1.0;
    std::size_t i = 0;
    while (i + 1 < level_.size() && level_[i + 1] >= level) ++i;
    if (i + 1 == level_.size()) return widest_;
    return angle(i) + (level_[i] - level) / (level_[i] - level_[i + 1]) * (angle(i + 1) - angle(i));
  }

 private:
  [[nodiscard]] double angle(std::size_t i) const noexcept {
    return widest_ * static_cast<double>(i) / static_cast<double>(level_.size() - 1);
  }

  double widest_;
  std::array<double, 65> level_{};
};

double positive_or(double value, double fallback) noexcept {
  return std::isfinite(value) && value > 0.0 ? value : fallback;
}

}  // namespace

DetectionTable::DetectionTable(const BeltConfig& belt, const DetectionParameters& parameters) {
  const BeltConfig usual;
  widest_ = std::clamp(0.5 * positive_or(belt.beam_rad, usual.beam_rad), kSmallestHalfBeam, 0.5 * kPi);
  cos_widest_ = std::cos(widest_);
  receiver_.full_gain_s = positive_or(parameters.full_gain_s, receiver_.full_gain_s);

  const double c = transducer_.sound_speed_mps;
  const double wavelength = transducer_.wavelength_m();
  const double edge_reach = positive_or(parameters.edge_reach_m, DetectionParameters{}.edge_reach_m);
  const auto amplified = [&](ElementKind kind, double z) {
    return reflection_amplitude(kind, z, wavelength) * receiver_.gain(2.0 * z / c);
  };
  receiver_.threshold = amplified(ElementKind::edge, edge_reach);
  const double near_plane = amplified(ElementKind::wall, 1.0);
  transducer_.radius_m = aperture_for(transducer_, widest_, receiver_.threshold / near_plane);

  const MainLobe lobe(transducer_, widest_);
  const double reach = std::min(positive_or(belt.max_range_m, usual.max_range_m), kFarthest);
  cells_per_metre_ = kCells / reach;
  const auto tabulate = [&](ElementKind kind) {
    std::vector<double> table;
    for (int k = 0; k <= static_cast<int>(kCells); ++k) {
      const double z = std::max(1.0 * k, 0.5) / cells_per_metre_;  // half a cell for the first: no echo comes from 0
      const double angle = lobe.reach(receiver_.threshold / amplified(kind, z));
      table.push_back(angle < 0.0 ? kNever : std::cos(angle));
    }
    return table;
  };
  plane_ = tabulate(ElementKind::wall);
  edge_ = tabulate(ElementKind::edge);
}

double DetectionTable::reach(ElementKind kind) const noexcept {
  const auto& table = kind == ElementKind::edge ? edge_ : plane_;
  if (kind == ElementKind::reflector) return kCells / cells_per_metre_;
  std::size_t last = table.size() - 1;
  while (last > 0 && table[last] > 1.0) --last;
  return static_cast<double>(std::min(last + 1, table.size() - 1)) / cells_per_metre_;
}

double DetectionTable::half_angle(ElementKind kind, double distance_m) const noexcept {
  const double cosine = kind == ElementKind::none ? kNever : cos_half_angle(kind, distance_m);
  return cosine > 1.0 ? -1.0 : std::acos(cosine);
}

}  // namespace echoway
