#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "echoway/belt/belt.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/motion/motion_hint.hpp"

namespace echoway {

/// What is known of the wearer's pose at the start; everything unset is unknown. check_start() says which can be.
struct Start {
  std::optional<RoomIndex> room;
  std::optional<Vec2> position;     ///< In the room's frame. REQUIRES: room.
  std::optional<double> heading;    ///< In the room's frame, radians. REQUIRES: room.
};

/// A sensor that seems not to say what is there.
struct SensorSuspicion {
  int sensor = 0;
  enum class Kind : std::uint8_t { silent, stuck, interference } kind = Kind::silent;
};

/// The wearer was told to take stairs or an elevator and stands at its end: for the next while echoes need not fit, and
/// then they should fit where it leads.
struct LevelTransition {
  std::size_t link = 0;          ///< Index into Building::links.
  RoomIndex from = kNoRoom;
  RoomIndex to = kNoRoom;
  double time_s = 0.0;           ///< When it was told.
  double patience_s = 0.0;       ///< How long it may take; 0: they are out.
};

/// Turns firings and motion hints, in order of time, into estimates. Implementations allocate nothing after start-up on
/// the firing path, never throw, and give the same answer on every run.
class Locator {
 public:
  Locator() = default;
  Locator(const Locator&) = delete;
  Locator& operator=(const Locator&) = delete;
  virtual ~Locator() = default;

  /// Returns true when estimate() has been renewed. A firing that is not usable (sensor out of range, NaN, time going
  /// back) is ignored.
  virtual bool on_firing(const Firing& firing) = 0;
  virtual void on_motion(const MotionHint& hint) = 0;
  /// Air temperature as the belt's thermometer reports it.
  virtual void on_temperature(double celsius) = 0;
  /// A hint, not a fact: the wearer may stay.
  virtual void on_level_transition(const LevelTransition& /*transition*/) {}

  /// Whether somebody leads the wearer to a destination from now on: who is led takes stairs only when told to.
  virtual void on_led(bool /*led*/) {}

  /// The wearer may not be where estimate() says (see Guide::take_doubt): other places are to be looked for. Evidence,
  /// not a fact.
  virtual void on_doubt() {}

  [[nodiscard]] virtual const Estimate& estimate() const = 0;
  /// Most probable first; at least one once estimate() has a room.
  [[nodiscard]] virtual std::span<const Hypothesis> hypotheses() const = 0;
  [[nodiscard]] virtual std::span<const SensorSuspicion> suspicions() const = 0;
};

}  // namespace echoway
