#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "layouts.hpp"
#include "plans/plans.hpp"
#include "reader.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

constexpr std::byte kGuard{0xa5};
constexpr std::size_t kGuardBytes = 64;

Estimate any_estimate(Reader& in) {
  Estimate e;
  e.room = in.integer();
  e.state = static_cast<TrackState>(in.byte());
  for (double* field : {&e.time_s, &e.pose.position.x, &e.pose.position.y, &e.pose.heading, &e.sigma_m,
                        &e.sigma_heading_rad, &e.room_probability, &e.covariance_xx, &e.covariance_xy,
                        &e.covariance_yy, &e.speed_mps, &e.sound_speed_scale}) {
    *field = in.number();
  }
  return e;
}

BeltHealth any_health(Reader& in) {
  BeltHealth health;
  health.link = static_cast<BeltLink>(in.byte());
  health.sensor_count = in.integer();
  health.temperature_c = in.number();
  // Without the terminator that it should have.
  for (char& c : health.firmware) c = static_cast<char>(in.byte());
  for (SensorHealth& sensor : health.sensors) {
    sensor.state = static_cast<SensorState>(in.byte());
    sensor.firings = in.integer();
    sensor.last_range_m = in.number();
  }
  return health;
}

std::string any_text(Reader& in) {
  const auto bytes = in.bytes(in.byte());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Building any_building(Reader& in) {
  Building building = plans::three_rooms();
  building.name = any_text(in);
  for (Room& room : building.rooms) {
    room.id = any_text(in);
    room.name = any_text(in);
    room.level = in.integer();
    room.walls.resize(in.byte(), {{in.number(), in.number()}, {in.number(), in.number()}});
    room.boundary.resize(in.byte() % 8, std::vector<Vec2>(in.byte() % 8));
  }
  building.places.resize(in.byte() % 16, {in.integer(), {in.number(), in.number()}, any_text(in)});
  return building;
}

Cue any_cue(Reader& in) {
  Cue cue;
  cue.kind = static_cast<CueKind>(in.byte());
  cue.urgency = static_cast<Urgency>(in.byte());
  for (double* field : {&cue.time_s, &cue.direction, &cue.distance_m, &cue.sigma_m, &cue.time_to_live_s, &cue.tail.direction,
                        &cue.tail.distance_m}) {
    *field = in.number();
  }
  for (std::int32_t* field : {&cue.count, &cue.room, &cue.landmark.index}) *field = in.integer();
  cue.landmark.kind = static_cast<CueLandmark::Kind>(in.byte());
  cue.tail.kind = static_cast<CueKind>(in.byte());
  cue.tail.present = in.byte() % 2 != 0;
  return cue;
}

Route any_route(Reader& in) {
  Route route;
  route.length_m = in.number();
  route.waypoints.resize(in.byte(), {.room = in.integer(), .at = {in.number(), in.number()}});
  return route;
}

/// A cue is cut to the buffer, never dropped.
std::string check_cue(const Cue& cue, const std::string& words, std::size_t size) {
  std::vector<std::byte> memory(size + kGuardBytes, kGuard);
  const std::size_t written = jni::write_cue(cue, words, std::span(memory).first(size));
  if (!std::all_of(memory.begin() + static_cast<std::ptrdiff_t>(size), memory.end(), [](std::byte b) { return b == kGuard; })) {
    return "a cue was written behind its buffer";
  }
  if (size < jni::kCueFixedBytes) return "";
  if (written > size) return "a cue that could be cut did not fit";
  // The words must not end within a character that they hold whole.
  const std::size_t kept = written - jni::kCueFixedBytes;
  const bool within = kept < words.size() && (static_cast<unsigned char>(words[kept]) & 0xC0) == 0x80;
  return within ? "a cue was cut within a character" : "";
}

/// Writes into a buffer of `size` bytes between guards. `write` must say what it needs whatever the size, touch nothing
/// outside, and fill exactly what it says when that fits.
template <class Write>
std::string check_writer(std::size_t size, Write write) {
  std::vector<std::byte> memory(size + 2 * kGuardBytes, kGuard);
  const std::span<std::byte> out(memory.data() + kGuardBytes, size);
  const std::size_t needed = write(out);
  if (needed != write(std::span<std::byte>{})) return "the size needed depends on the buffer";
  const auto intact = [](auto first, auto last) { return std::all_of(first, last, [](std::byte b) { return b == kGuard; }); };
  if (!intact(memory.begin(), memory.begin() + kGuardBytes)) return "wrote in front of the buffer";
  const auto end = static_cast<std::ptrdiff_t>(kGuardBytes + std::min(needed, size));
  if (!intact(memory.begin() + end, memory.end())) return "wrote behind what it needs";
  return "";
}

}  // namespace

std::string jni_layouts(Bytes data) {
  Reader in(data);
  const std::size_t size = in.word();
  const Estimate estimate = any_estimate(in);
  const BeltHealth health = any_health(in);
  const Building building = any_building(in);
  const Cue cue = any_cue(in);
  const Route route = any_route(in);
  const std::vector<Spot> spots(in.byte(), {in.integer(), {in.number(), in.number()}});
  const std::vector<Hypothesis> hypotheses(in.byte(), {in.integer(), {{in.number(), in.number()}, in.number()}, 0.0, 0.0});
  const std::vector<ExplainedEcho> echoes(in.byte() % 65U, {.firing = {in.number(), in.byte(), in.number()}});
  const std::vector<Finding> findings(in.byte(), {Finding::Severity::warning, Finding::Kind::bad_line, any_text(in), in.integer(), any_text(in)});
  const std::string words = any_text(in);
  std::string broken = check_writer(size, [&](auto out) { return jni::write_estimate(estimate, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_belt_health(health, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_plan(building, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_route(route, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_spots(spots, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_hypotheses(hypotheses, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_echoes(echoes, out); });
  if (broken.empty()) broken = check_writer(size, [&](auto out) { return jni::write_findings(findings, out); });
  if (broken.empty()) broken = check_cue(cue, words, size);
  return broken;
}

}  // namespace echoway::fuzz
