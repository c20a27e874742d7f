#include <algorithm>
#include <cmath>

#include "echoway/speech/speaker.hpp"
#include "echoway/units.hpp"

namespace echoway {
namespace {

/// From this standard deviation on a number would pretend to know, metres.
constexpr double kVagueSigma = 0.75;

struct Scale {
  double metres;       ///< Of one unit.
  double fine;         ///< Grain below `threshold`, units.
  double coarse;       ///< Grain from there on.
  double threshold;    ///< Units.
};

Scale scale_of(const SpeechStyle& style) {
  switch (style.length) {
    case LengthStyle::metres:
      return {1.0, 0.5, 1.0, 3.0};
    case LengthStyle::steps:
      return {std::isfinite(style.step_length_m) ? std::clamp(style.step_length_m, 0.3, 1.2) : 0.65, 1.0, 5.0, 10.0};
    case LengthStyle::feet:
      break;
  }
  return {kMetresPerFoot, 1.0, 5.0, 10.0};
}

int vague_step(double metres) {
  if (metres < 1.2) return 0;
  if (metres < 3.5) return 1;
  return metres < 8.0 ? 2 : 3;
}

}  // namespace

SpokenLength spoken_length(double metres, double sigma_m, const SpeechStyle& style) noexcept {
  constexpr double kLongest = 1e5;
  const double length = std::isfinite(metres) ? std::clamp(metres, 0.0, kLongest) : kLongest;
  if (!(sigma_m < kVagueSigma)) return {true, vague_step(length), 0};
  const Scale scale = scale_of(style);
  const double units = length / scale.metres;
  const bool fine = units < scale.threshold && sigma_m <= scale.fine * scale.metres;
  const double grain = fine ? scale.fine : scale.coarse;
  // The least that the coarse grain can say would be twice as far and more.
  if (!fine && units < 0.5 * grain) return {true, vague_step(length), 0};
  const double rounded = std::max(grain, grain * std::round(units / grain));
  return {false, 0, static_cast<int>(std::lround(2.0 * rounded))};
}

}  // namespace echoway
