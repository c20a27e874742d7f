#include "guidance/probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "guidance/echo_preview.hpp"

namespace echoway::guidance {
namespace {

constexpr std::size_t kPlaces = 4;       ///< More hypotheses than this say little.
constexpr double kStep = 0.6;            ///< Metres.
constexpr double kStepRoom = 0.9;        ///< Free metres that a step needs.
constexpr double kClearlyBetter = 1.25;  ///< By how much a step must beat turning.

using Ranges = std::array<double, kMaxSensors>;

void predict(const Router& router, const BeltConfig& belt, RoomIndex room, const Pose2& pose, Ranges& ranges) {
  for (int i = 0; i < belt.sensors; ++i) {
    const double axis = pose.heading + belt.bearing(i);
    const Vec2 face = pose.position + belt.radius_m * unit_from_angle(axis);
    ranges[static_cast<std::size_t>(i)] = preview_range(router.building().room(room), router.space(room), face, axis,
                                                        0.5 * belt.beam_rad, belt.max_range_m);
  }
}

/// Share of the sensors that would say something else.
double difference(const BeltConfig& belt, const Ranges& a, const Ranges& b) {
  int differ = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(belt.sensors); ++i) {
    const double noise = 0.05 + 3.0 * belt.range_noise * std::min(a[i], b[i]);
    differ += std::abs(a[i] - b[i]) > noise ? 1 : 0;
  }
  return static_cast<double>(differ) / belt.sensors;
}

Pose2 moved(const Pose2& pose, double turn, double step_direction, double step) {
  return {pose.position + step * unit_from_angle(pose.heading + step_direction), wrap_angle(pose.heading + turn)};
}

double disagreement(const Router& router, const BeltConfig& belt, std::span<const Hypothesis> places, double turn,
                    double step_direction, double step) {
  std::array<Ranges, kPlaces> predicted;
  for (std::size_t i = 0; i < places.size(); ++i) {
    predict(router, belt, places[i].room, moved(places[i].pose, turn, step_direction, step), predicted[i]);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      sum += places[i].probability * places[j].probability * difference(belt, predicted[i], predicted[j]);
    }
  }
  return sum;
}

}  // namespace

Probe choose_probe(const Router& router, const BeltConfig& belt, std::span<const Hypothesis> all) {
  std::array<Hypothesis, kPlaces> kept;
  std::size_t count = 0;
  for (const Hypothesis& h : all) {
    const bool known = router.building().has_room(h.room);
    if (count < kPlaces && known && is_finite(h.pose)) kept[count++] = h;
  }
  const std::span<const Hypothesis> places(kept.data(), count);
  Probe best;
  if (count < 2) return best;
  // Turning passes many headings: every eighth of a beam's spacing on the way counts.
  const double spacing = kTwoPi / belt.sensors;
  for (const double side : {1.0, -1.0}) {
    double sum = 0.0;
    constexpr int kStops = 4;
    for (int k = 1; k <= kStops; ++k) sum += disagreement(router, belt, places, side * k * spacing / kStops, 0.0, 0.0);
    if (sum / kStops > best.disagreement) best = {Probe::Action::turn, side * kPi / 2, sum / kStops};
  }
  double to_beat = best.disagreement * kClearlyBetter;
  for (const double direction : {0.0, kPi / 2, -kPi / 2, kPi}) {
    const bool safe = std::all_of(places.begin(), places.end(), [&](const Hypothesis& h) {
      return router.space(h.room).reach(h.pose.position, unit_from_angle(h.pose.heading + direction), 2.0) > kStepRoom;
    });
    if (!safe) continue;
    const double sum = disagreement(router, belt, places, 0.0, direction, kStep);
    if (sum <= to_beat) continue;
    to_beat = sum;
    best = {Probe::Action::step, direction, sum};
  }
  return best;
}

}  // namespace echoway::guidance
