#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tracker/strangers.hpp"

namespace echoway::tracker {

/// The last echo of a sensor, which a reading may repeat.
struct Repeat {
  std::size_t slot = 0;     ///< Under which particles remember it.
  double sigma = 0.0;       ///< Metres by which the thing that answered may be nearer or farther off by now.
  double alike = 0.0;       ///< Density of the reading's range, per metre, if the same sensor has it from a thing that
                            ///< went along with the wearer.
};

/// What answered a moment ago answers again: a cupboard from where it stood, an arm from the same distance, a rough
/// wall from beside the wearer all the while. So a run of echoes from something that is in no plan is one surprise, not
/// many, and must not outweigh the true place by its number. The newest echo of every sensor is kept for two and a half
/// seconds; where it came from, and whether from the plan, is each particle's own opinion (Strangers).
class EchoRepeats {
 public:
  /// `sensor` heard an echo from `range` metres at `time_s` seconds, of which particles have taken a note.
  void note(int sensor, double range, double time_s) noexcept;
  /// What may be repeated by an echo from `range` metres that `sensor` hears at `time_s`.
  [[nodiscard]] std::span<const Repeat> match(int sensor, double range, double time_s) noexcept;
  [[nodiscard]] static std::size_t slot_of(int sensor) noexcept {
    return static_cast<std::size_t>(sensor) % Strangers::kSlots;
  }

 private:
  struct Last {
    int sensor = 0;
    double time_s = -1e300;
    double range = 0.0;
  };
  std::array<Last, Strangers::kSlots> last_{};
  std::array<Repeat, Strangers::kSlots> found_{};
};

}  // namespace echoway::tracker
