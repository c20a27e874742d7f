#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "echoway/belt/belt_health.hpp"
#include "echoway/building/building.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/guidance/cue.hpp"
#include "echoway/locate/estimate.hpp"
#include "echoway/routing/route.hpp"
#include "echoway/scene/echo_explainer.hpp"

// How the core's records cross to Kotlin: through direct buffers, in the machine's byte order, without padding. The
// Kotlin side of each is named beside it; docs/app-architecture.md has the tables.
namespace echoway::jni {

/// org.echoway.core.EstimateLayout: time, x, y, heading, sigma, sigma heading, room probability, covariance xx, xy, yy,
/// speed, sound speed scale (f64 each), room, state (i32 each).
inline constexpr std::size_t kEstimateBytes = 12 * 8 + 2 * 4;
/// Returns the bytes needed; nothing is promised of `out` when it is smaller.
std::size_t write_estimate(const Estimate& estimate, std::span<std::byte> out) noexcept;

/// org.echoway.core.BeltHealthLayout: link, sensor count (i32), firings per second (f64), good, bad checksum,
/// malformed, lost firings, restarts (i64), has temperature, has battery (i32), temperature, battery (f64), firmware
/// (24 bytes); then kMaxSensors times state, firings, echoes, fault code (i32), last range, last time (f64).
inline constexpr std::size_t kBeltHealthBytes = 2 * 4 + 8 + 5 * 8 + 2 * 4 + 2 * 8 + 24 + kMaxSensors * (4 * 4 + 2 * 8);
std::size_t write_belt_health(const BeltHealth& health, std::span<std::byte> out) noexcept;

/// org.echoway.core.PlanLayout: name; rooms (id, name, number and name aloud, level, frame x y heading, walls, boundary
/// loops); doors; level links; exits; places. Every list starts with its length (i32), every text with its length in
/// bytes (i32).
std::size_t write_plan(const Building& building, std::span<std::byte> out) noexcept;

/// org.echoway.core.CueLayout: time, direction, distance, sigma, time to live (f64), kind, urgency, has direction, up,
/// count, room, landmark kind, landmark index, has tail, tail kind (i32), tail direction, tail distance (f64), words
/// (text). Words that do not fit are cut between two characters: a cue is fetched once and must not be lost.
inline constexpr std::size_t kCueFixedBytes = 5 * 8 + 10 * 4 + 2 * 8 + 4;
std::size_t write_cue(const Cue& cue, std::string_view words, std::span<std::byte> out) noexcept;

/// org.echoway.core.RouteLayout: length, clearance (f64), uses stairs, uses elevator, goal kind, goal index (i32);
/// waypoints: room, x, y, kind, index, next room, next x, next y.
std::size_t write_route(const Route& route, std::span<std::byte> out) noexcept;

/// A list of spots: room (i32), x, y (f64).
std::size_t write_spots(std::span<const Spot> spots, std::span<std::byte> out) noexcept;

/// A list of hypotheses: room (i32), x, y, heading, sigma, probability (f64).
std::size_t write_hypotheses(std::span<const Hypothesis> hypotheses, std::span<std::byte> out) noexcept;

/// A list of echoes by sensor: time, range (f64), kind, room (i32), x, y, expected range (f64).
std::size_t write_echoes(std::span<const ExplainedEcho> echoes, std::span<std::byte> out) noexcept;

/// A list of findings: severity, kind, line (i32), file, message (text).
std::size_t write_findings(const std::vector<Finding>& findings, std::span<std::byte> out) noexcept;

}  // namespace echoway::jni
