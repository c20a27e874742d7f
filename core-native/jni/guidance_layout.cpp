#include "byte_writer.hpp"
#include "layouts.hpp"
#include "write_list.hpp"

namespace echoway::jni {
namespace {

/// As much of `text` as fits into `size` bytes of UTF-8, cut between two characters.
std::string_view fitting(std::string_view text, std::size_t size) noexcept {
  if (text.size() <= size) return text;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size);
}

}  // namespace

std::size_t write_cue(const Cue& cue, std::string_view words, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  w.f64(cue.time_s);
  w.f64(cue.direction);
  w.f64(cue.distance_m);
  w.f64(cue.sigma_m);
  w.f64(cue.time_to_live_s);
  w.i32(static_cast<std::int32_t>(cue.kind));
  w.i32(static_cast<std::int32_t>(cue.urgency));
  w.i32(cue.has_direction ? 1 : 0);
  w.i32(cue.up ? 1 : 0);
  w.i32(cue.count);
  w.i32(cue.room);
  w.i32(static_cast<std::int32_t>(cue.landmark.kind));
  w.i32(cue.landmark.index);
  w.i32(cue.tail.present ? 1 : 0);
  w.i32(static_cast<std::int32_t>(cue.tail.kind));
  w.f64(cue.tail.direction);
  w.f64(cue.tail.distance_m);
  w.text(out.size() < kCueFixedBytes ? words : fitting(words, out.size() - kCueFixedBytes));
  return w.size();
}

std::size_t write_route(const Route& route, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  w.f64(route.length_m);
  w.f64(route.clearance_m);
  w.i32(route.uses_stairs ? 1 : 0);
  w.i32(route.uses_elevator ? 1 : 0);
  w.i32(static_cast<std::int32_t>(route.goal.kind));
  w.i32(route.goal.index);
  write_list(w, route.waypoints, [&](const Waypoint& point) {
    w.i32(point.room);
    write(w, point.at);
    w.i32(static_cast<std::int32_t>(point.kind));
    w.i32(point.index);
    w.i32(point.next_room);
    write(w, point.next_at);
  });
  return w.size();
}

std::size_t write_spots(std::span<const Spot> spots, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  write_list(w, spots, [&](const Spot& spot) {
    w.i32(spot.room);
    write(w, spot.at);
  });
  return w.size();
}

std::size_t write_hypotheses(std::span<const Hypothesis> hypotheses, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  write_list(w, hypotheses, [&](const Hypothesis& place) {
    w.i32(place.room);
    write(w, place.pose.position);
    w.f64(place.pose.heading);
    w.f64(place.sigma_m);
    w.f64(place.probability);
  });
  return w.size();
}

std::size_t write_echoes(std::span<const ExplainedEcho> echoes, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  write_list(w, echoes, [&](const ExplainedEcho& echo) {
    w.f64(echo.firing.time_s);
    w.f64(echo.firing.range_m);
    w.i32(static_cast<std::int32_t>(echo.kind));
    w.i32(echo.room);
    write(w, echo.at);
    w.f64(echo.expected_m);
  });
  return w.size();
}

std::size_t write_findings(const std::vector<Finding>& findings, std::span<std::byte> out) noexcept {
  ByteWriter w(out);
  write_list(w, findings, [&](const Finding& finding) {
    w.i32(static_cast<std::int32_t>(finding.severity));
    w.i32(static_cast<std::int32_t>(finding.kind));
    w.i32(finding.line);
    w.text(finding.file);
    w.text(finding.message);
  });
  return w.size();
}

}  // namespace echoway::jni
