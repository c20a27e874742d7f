#include "plans/session_promises.hpp"

#include <cmath>

#include "echoway/speech/speaker.hpp"

namespace echoway::plans {
namespace {

constexpr int kMostCues = 64;  // Waiting at once.

bool usable(const Pose2& pose) { return is_finite(pose) && pose.heading > -4.0 && pose.heading < 4.0; }

std::string check(const Estimate& e, const Building& building) {
  if (e.room != kNoRoom && !building.has_room(e.room)) return "the estimate's room does not exist";
  for (const double value : {e.time_s, e.sigma_m, e.sigma_heading_rad, e.room_probability, e.covariance_xx,
                             e.covariance_xy, e.covariance_yy, e.speed_mps, e.sound_speed_scale}) {
    if (!std::isfinite(value)) return "the estimate has something that is not finite";
  }
  if (!usable(e.pose)) return "the estimate's pose is not finite";
  if (e.sigma_m < 0.0 || e.sigma_heading_rad < 0.0) return "a negative sigma";
  if (e.room_probability < 0.0 || e.room_probability > 1.0 + 1e-9) return "the room's probability is none";
  if (e.covariance_xx < 0.0 || e.covariance_yy < 0.0) return "a negative variance";
  return static_cast<int>(e.state) <= static_cast<int>(TrackState::lost) ? "" : "no such state";
}

std::string check(const Estimate& estimate, std::span<const Hypothesis> hypotheses, const Building& building) {
  if (std::string broken = check(estimate, building); !broken.empty()) return broken;
  double total = 0.0;
  for (const Hypothesis& h : hypotheses) {
    if (!usable(h.pose) || !std::isfinite(h.sigma_m) || !(h.probability >= 0.0)) return "a hypothesis is not finite";
    if (!building.has_room(h.room)) return "a hypothesis in no room";
    total += h.probability;
  }
  return total <= 1.0 + 1e-9 ? "" : "hypotheses that add up to more than 1";
}

std::string check(const BeltHealth& health) {
  for (const double value : {health.firings_per_second, health.temperature_c, health.battery_v}) {
    if (!std::isfinite(value)) return "the belt's health is not finite";
  }
  if (health.firings_per_second < 0.0) return "a negative rate";
  if (health.sensor_count < 0 || health.sensor_count > kMaxSensors) return "no such number of sensors";
  for (const SensorHealth& s : health.sensors) {
    if (!std::isfinite(s.last_range_m) || !std::isfinite(s.last_time_s)) return "a sensor's health is not finite";
    if (s.firings < 0 || s.echoes < 0 || s.echoes > s.firings) return "a sensor with more echoes than firings";
  }
  return "";
}

bool usable(const Spot& spot, const Building& building) {
  return is_finite(spot.at) && (spot.room == kNoRoom || building.has_room(spot.room));
}

std::string check(const Cue& cue) {
  for (const double value : {cue.time_s, cue.direction, cue.distance_m, cue.sigma_m, cue.time_to_live_s,
                             cue.tail.direction, cue.tail.distance_m}) {
    if (!std::isfinite(value)) return "a cue has something that is not finite";
  }
  if (!(std::fabs(cue.direction) <= kPi) || !(std::fabs(cue.tail.direction) <= kPi)) return "a cue points nowhere";
  return cue.sigma_m < 0.0 || cue.count < 0 ? "a cue counts backwards" : "";
}

std::string check(const Route& route, const Building& building) {
  if (!std::isfinite(route.length_m) || route.length_m < 0.0) return "a route of no length";
  if (!std::isfinite(route.clearance_m)) return "a route beside nothing";
  for (const Waypoint& point : route.waypoints) {
    if (!usable({point.room, point.at}, building) || !is_finite(point.next_at)) return "a waypoint is nowhere";
  }
  return "";
}

/// In every language, direction and length.
bool has_words(const Cue& cue, const Building& building) {
  for (const Language language : {Language::english, Language::german, Language::french}) {
    for (const DirectionStyle direction : {DirectionStyle::sides, DirectionStyle::clock, DirectionStyle::degrees}) {
      for (const LengthStyle length : {LengthStyle::feet, LengthStyle::metres, LengthStyle::steps}) {
        if (Speaker(building, {language, direction, length}).say(cue).empty()) return false;
      }
    }
  }
  return true;
}

template <class Guiding>
std::string check(Guiding& guiding, const Building& building) {
  Cue cue;
  for (int cues = 0; guiding.next_cue(cue); ++cues) {
    if (std::string broken = check(cue); !broken.empty()) return broken;
    if (!has_words(cue, building)) return "a cue without words";
    if (cues > kMostCues) return "cues without end";
  }
  if (std::string broken = check(guiding.route(), building); !broken.empty()) return broken;
  if (!std::isfinite(guiding.obstacle_ahead_m())) return "an obstacle at no distance";
  for (const Spot& crumb : guiding.breadcrumbs()) {
    if (!usable(crumb, building)) return "a breadcrumb is nowhere";
  }
  return "";
}

}  // namespace

std::string broken_health(const BeltHealth& health) { return check(health); }

std::string broken_guidance(Session& session) { return check(session, session.building()); }

std::string broken_guidance(Guide& guide, const Building& building) { return check(guide, building); }

std::string broken_explanation(Session& session) {
  for (const ExplainedEcho& echo : session.explain_scan()) {
    if (!usable({echo.room, echo.at}, session.building()) || !std::isfinite(echo.expected_m)) {
      return "an echo from nowhere";
    }
  }
  return "";
}

std::string broken_promise(const Locator& locator, const Building& building) {
  return check(locator.estimate(), locator.hypotheses(), building);
}

std::string broken_promise(const Session& session) {
  if (std::string broken = check(session.estimate(), session.hypotheses(), session.building()); !broken.empty()) {
    return broken;
  }
  for (const Firing& f : session.last_scan()) {
    if (!std::isfinite(f.time_s) || !std::isfinite(f.range_m)) return "the last scan is not finite";
  }
  return check(session.belt_health());
}

}  // namespace echoway::plans
