#pragma once

#include <array>
#include <span>

#include "echoway/belt/belt.hpp"
#include "echoway/random.hpp"
#include "scene/scene.hpp"
#include "tracker/echo_memory.hpp"
#include "tracker/echo_model.hpp"
#include "tracker/echo_repeats.hpp"
#include "tracker/history.hpp"
#include "tracker/particle.hpp"

namespace echoway::tracker {

/// One firing, prepared for all particles.
struct Shot {
  Vec2 bearing{1.0, 0.0};   ///< cos, sin of the sensor's direction on the belt.
  double bearing_rad = 0.0;
  double radius = 0.0;      ///< Axis to transducer, metres.
  double range = 0.0;       ///< Metres; ignored without an echo.
  bool echo = false;
  bool coarse = false;      ///< Particles stand for cells of headings.
  std::span<const Spot> spots{};  ///< Unmapped things that may have answered.
  int sensor = 0;
  std::span<const Repeat> repeats{};  ///< Earlier echoes that this one may repeat.
  double trust = 1.0;       ///< 0: the sensor says nothing, 1: believe the model.
  double novelty = 1.0;     ///< Share of the reading that is not said again: its error is worth so much less often.
};

/// The sensor's direction in the particle's frame.
[[nodiscard]] inline Vec2 axis_of(const Particle& p, const Shot& shot) noexcept {
  return rotated(shot.bearing, p.facing);
}

/// `bearing`: cos, sin of the sensor's direction on the belt.
[[nodiscard]] Shot shot_of(const Record& record, const BeltConfig& belt, Vec2 bearing) noexcept;

inline constexpr double kGate2 = 30.0;          ///< Squared innovations beyond this many variances weigh nothing.
inline constexpr double kLeastDensity = 1e-12;  ///< A density never falls below this.

/// An echo that the map lets a particle expect.
struct ExpectedEcho {
  double range;             ///< Metres: true distance from the transducer's face.
  double chance;            ///< That it answers when nothing nearer does.
  double extra_variance;    ///< Metres^2, besides the model's.
  double gradient_x;        ///< Of `range` over position.
  double gradient_y;
  std::uint16_t reflector;  ///< Which answers: RoomScene::reflectors.
  bool of_wall;             ///< A wall squarely in the beam, before which furniture may stand.

  [[nodiscard]] Vec2 gradient() const noexcept { return {gradient_x, gradient_y}; }
};

/// Expected echoes, nearest first.
struct ExpectedEchoes {
  static constexpr int kMax = 8;
  int count = 0;
  std::array<ExpectedEcho, kMax> echo;   ///< The first `count`. The rest is not zeroed: thousands are made a firing.
};

[[nodiscard]] ExpectedEchoes expect(const Particle& particle, const Shot& shot, const EchoModel& model,
                                    scene::Scene& scene) noexcept;
/// The same from a given list of what may be seen.
[[nodiscard]] ExpectedEchoes expect_from(const scene::Cell& cell, const scene::RoomScene& room,
                                         const Particle& particle, const Shot& shot, const EchoModel& model) noexcept;

struct Outcome {
  double density = 0.0;     ///< Of the reading, per metre for an echo and a plain probability for none.
  double plan = 0.0;        ///< The density if nothing were remembered.
  double mapped = 0.0;      ///< Probability that something in the plan answered.
};

/// What the shot's reading says of a particle. Reflectors answer in order of distance, the nearest that does wins:
///   p(z) = (1 - deaf) [quiet sum_j c_j prod_{i<j} (1 - c_i) N(z; d_j, S_j)
///                      + unmapped(z) prod_{d_i < z} (1 - c_i)] + ghost,
///   p(none) = deaf + (1 - deaf) quiet prod (1 - c_i).
/// What stands before walls (Fronts) or answered a moment ago (Strangers) adds to p(z) in the same way.
/// Always finite and positive.
[[nodiscard]] Outcome weigh(const Particle& particle, const Shot& shot, const EchoModel& model,
                            scene::Scene& scene) noexcept;

/// The same, and an echo updates the particle's Gaussian, see merge(), and is taken down in `strangers`, from where and
/// how likely nothing in the plan answered, and in `fronts`, if something before a wall may have.
Outcome assimilate(Particle& particle, const Shot& shot, const EchoModel& model, scene::Scene& scene) noexcept;
/// For who is followed: see merge_or_choose(). Who is looked for may be at so many places, each of so few particles,
/// that draws would lose them.
Outcome assimilate(Particle& particle, const Shot& shot, const EchoModel& model, scene::Scene& scene,
                   Random& random) noexcept;

/// What a reading says of a particle that is in no room, where it has this `density`, per metre for an echo and a plain
/// probability for none. Nothing in the plan answers, which `strangers` takes down, but what answered a moment ago may
/// answer again, as far as the sensor is trusted.
Outcome hear_in_no_room(Particle& particle, const Shot& shot, const EchoModel& model, double density) noexcept;

}  // namespace echoway::tracker
