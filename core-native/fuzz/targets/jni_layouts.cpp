#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "layouts.hpp"
#include "plans/plans.hpp"
#include "reader.hpp"
#include "target.hpp"
#include "text/utf8.hpp"

namespace echoway::fuzz {
namespace {

constexpr std::uint8_t kGuard{0xa5};
constexpr std::size_t kGuardBytes = 64;
constexpr std::size_t kLargestBuffer = 8192;  ///< Most inputs fit; the rest must be refused.

/// A buffer between guards. Filled and compared in one piece each: a loop over bytes is slow under the sanitizers.
class Guarded {
 public:
  explicit Guarded(std::size_t size)
      : size_(size), memory_(std::make_unique_for_overwrite<std::byte[]>(size + 2 * kGuardBytes)) {
    std::memset(memory_.get(), kGuard, size + 2 * kGuardBytes);
  }

  [[nodiscard]] std::span<std::byte> inside() noexcept { return {memory_.get() + kGuardBytes, size_}; }
  [[nodiscard]] bool front_intact() const noexcept { return intact(0, kGuardBytes); }
  /// From `used` bytes of the inside on.
  [[nodiscard]] bool rest_intact(std::size_t used) const noexcept {
    return intact(kGuardBytes + used, size_ - used + kGuardBytes);
  }

 private:
  [[nodiscard]] bool intact(std::size_t begin, std::size_t count) const noexcept {
    static const std::vector<std::uint8_t> pristine(kLargestBuffer + kGuardBytes, kGuard);
    return std::memcmp(memory_.get() + begin, pristine.data(), count) == 0;
  }

  std::size_t size_;
  std::unique_ptr<std::byte[]> memory_;
};

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

/// Fewer than `limit` copies of what `make` makes. (Not `std::vector(in.byte(), ...)`: the compilers disagree on the
/// order of a call's arguments, and an input must mean the same to all.)
template <class Make>
auto copies(Reader& in, std::size_t limit, Make make) {
  const std::size_t count = in.byte() % limit;
  return std::vector(count, make());
}

Vec2 any_point(Reader& in) {
  const double x = in.number();
  return {x, in.number()};
}

Building any_building(Reader& in) {
  Building building = plans::three_rooms();
  building.name = any_text(in);
  for (Room& room : building.rooms) {
    room.id = any_text(in);
    room.name = any_text(in);
    room.level = in.integer();
    room.walls = copies(in, 32, [&] { return Segment{any_point(in), any_point(in)}; });
    room.boundary = copies(in, 8, [&] { return std::vector<Vec2>(in.byte() % 8); });
  }
  building.places = copies(in, 16, [&] { return Landmark{in.integer(), any_point(in), any_text(in)}; });
  return building;
}

Cue any_cue(Reader& in) {
  Cue cue;
  cue.kind = static_cast<CueKind>(in.byte());
  cue.urgency = static_cast<Urgency>(in.byte());
  for (double* field : {&cue.time_s, &cue.direction, &cue.distance_m, &cue.sigma_m, &cue.time_to_live_s,
                        &cue.tail.direction, &cue.tail.distance_m}) {
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
  route.waypoints = copies(in, 256, [&] { return Waypoint{.room = in.integer(), .at = any_point(in)}; });
  return route;
}

/// A cue is cut to the buffer, never dropped.
std::string check_cue(const Cue& cue, const std::string& words, std::size_t size) {
  Guarded memory(size);
  const std::size_t written = jni::write_cue(cue, words, memory.inside());
  if (!memory.front_intact() || !memory.rest_intact(size)) return "a cue was written outside its buffer";
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
  Guarded memory(size);
  const std::size_t needed = write(memory.inside());
  if (needed != write(std::span<std::byte>{})) return "the size needed depends on the buffer";
  if (!memory.front_intact()) return "wrote in front of the buffer";
  return memory.rest_intact(std::min(needed, size)) ? "" : "wrote behind what it needs";
}

}  // namespace

std::string jni_layouts(Bytes data) {
  Reader in(data);
  const std::size_t size = in.word() % (kLargestBuffer + 1);
  const Estimate estimate = any_estimate(in);
  const BeltHealth health = any_health(in);
  const Building building = any_building(in);
  const Cue cue = any_cue(in);
  const Route route = any_route(in);
  const auto spots = copies(in, 256, [&] { return Spot{in.integer(), any_point(in)}; });
  const auto hypotheses =
      copies(in, 256, [&] { return Hypothesis{in.integer(), {any_point(in), in.number()}, 0.0, 0.0}; });
  const auto echoes =
      copies(in, kMaxSensors + 1, [&] { return ExplainedEcho{.firing = {in.number(), in.byte(), in.number()}}; });
  const auto findings = copies(in, 256, [&] {
    return Finding{Finding::Severity::warning, Finding::Kind::bad_line, any_text(in), in.integer(), any_text(in)};
  });
  const std::string words = text::to_utf8(any_text(in));  // As a speaker's are, whatever the files hold.
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
