#include "faults/fault.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "echoway/belt/sentence.hpp"
#include "echoway/guidance/cue.hpp"
#include "echoway/session.hpp"
#include "echoway/speech/speaker.hpp"
#include "plans/error_of.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"

namespace echoway::faults {
namespace {

constexpr double kLatency = 0.005;
constexpr double kTick = 0.25;

/// What a wearer is told of the state of belt and estimate, in the words of the speech tables.
class Ear {
 public:
  Ear(const Building& building, Report& result) : speaker_(building), result_(result) {}

  void listen(const Session& session, double now) {
    const BeltHealth& health = session.belt_health();
    if (link_ == BeltLink::connected && health.link == BeltLink::lost) hear(make_cue(CueKind::belt_lost), now);
    if (link_ == BeltLink::lost && health.link == BeltLink::connected) hear(make_cue(CueKind::belt_back), now);
    link_ = health.link;
    for (int i = 0; i < session.config().belt.sensors; ++i) listen_to_sensor(session, i, now);
    const bool lost = session.estimate().state == TrackState::lost;
    if (lost && !lost_) hear(make_cue(CueKind::uncertain), now);
    lost_ = lost;
  }

 private:
  void listen_to_sensor(const Session& session, int sensor, double now) {
    const BeltHealth& health = session.belt_health();
    const SensorState state = health.sensors[static_cast<std::size_t>(sensor)].state;
    const bool bad = state == SensorState::silent || state == SensorState::stuck || state == SensorState::fault;
    if (!bad) {
      blocked_.erase(sensor);
    } else if (health.link == BeltLink::connected && blocked_.insert(sensor).second) {
      Cue cue = make_cue(CueKind::sensor_blocked);
      cue.has_direction = true;
      cue.direction = wrap_angle(session.config().belt.bearing(sensor));
      hear(cue, now);
    }
  }

  void hear(const Cue& cue, double now) { result_.heard.push_back({speaker_.say(cue), now - kBegin}); }

  Speaker speaker_;
  Report& result_;
  BeltLink link_ = BeltLink::absent;
  std::set<int> blocked_;
  bool lost_ = false;
};

void take(Session& session, const Event& event, Report& result) {
  switch (event.kind) {
    case Event::Kind::bytes: result.taken += session.on_bytes(event.bytes, event.time_s); break;
    case Event::Kind::attached: session.on_belt_attached(event.time_s); break;
    case Event::Kind::detached: session.on_belt_detached(event.time_s); break;
  }
}

/// Events, motion hints and ticks in order of time, as the phone would deliver them.
void play(Session& session, const Events& events, double end, Report& result) {
  Ear ear(session.building(), result);
  const std::vector<MotionHint>& hints = walk().motion;
  auto hint = hints.begin();
  auto event = events.begin();
  session.on_belt_attached(0.0);
  for (double tick = 0.0; tick <= end || event != events.end();) {
    const bool event_first = event != events.end() && event->time_s <= tick;
    const double now = event_first ? event->time_s : tick;
    for (; hint != hints.end() && hint->time_s <= now; ++hint) session.on_motion(*hint);
    if (event_first) {
      take(session, *event++, result);
    } else {
      session.on_tick(tick);
      tick += kTick;
    }
    ear.listen(session, now);
    if (result.broken.empty()) result.broken = plans::broken_promise(session);
  }
}

}  // namespace

const sim::Simulation& walk() {
  static const sim::Simulation result = [] {
    sim::Walk steps;
    steps.seed = 33;
    steps.start = {"hall", {1.2, 1.5}};
    steps.world = sim::make_world(sim::Profile::empty);
    steps.world.arms = 0.0;  // An arm that hangs beside the belt covers a sensor, which is another matter.
    for (int i = 0; i < 2; ++i) {
      steps.add(sim::GoTo{{"office", {1.5, 1.2}}});
      steps.add(sim::Pause{1.0});
      steps.add(sim::GoTo{{"office", {1.5, 4.0}}});
      steps.add(sim::GoTo{{"hall", {1.2, 1.5}}});
      steps.add(sim::Pause{1.0});
    }
    auto heard = sim::simulate(plans::three_rooms(), steps);
    return heard ? std::move(*heard) : sim::Simulation{};
  }();
  return result;
}

Events sentences_of(const sim::Simulation& heard) {
  Events events;
  const double c = speed_of_sound(kReferenceCelsius);
  std::uint16_t seq = 0;
  for (const Firing& firing : heard.scans.firings) {
    EchoSentence echo{seq++, static_cast<std::uint8_t>(firing.sensor), std::nullopt};
    if (firing.has_echo()) echo.tof_us = static_cast<std::uint32_t>(std::lround(2e6 * firing.range_m / c));
    const EncodedSentence encoded = encode(echo);
    const std::string_view text = encoded.text();
    events.push_back({Event::Kind::bytes, firing.time_s + kLatency, {text.begin(), text.end()}});
  }
  return events;
}

int invented(const Events& events, const Events& sent) {
  std::set<std::string, std::less<>> known;
  for (const Event& event : sent) known.emplace(event.bytes.begin(), event.bytes.end());
  SentenceDecoder decoder;
  int strangers = 0;
  for (const Event& event : events) {
    decoder.feed(event.bytes, [&](const Sentence& sentence) {
      strangers += !known.contains(encode(sentence).text());
    });
  }
  return strangers;
}

Report run(const Fault& fault) {
  Report result;
  SessionConfig config;
  config.start = {0, Vec2{1.2, 1.5}, 0.0};
  auto opened = Session::open(plans::three_rooms(), config);
  if (!opened || walk().truth.empty()) {
    result.broken = opened ? "the walk could not be simulated" : opened.error().message;
    return result;
  }
  const Events sent = sentences_of(walk());
  Events events = sent;
  fault.inject(events);
  result.sent = static_cast<int>(sent.size());
  result.invented = fault.corrupts ? invented(events, sent) : 0;
  play(**opened, events, sent.back().time_s, result);
  result.error_m = plans::error_of((*opened)->estimate(), walk().truth.back(), (*opened)->building());
  return result;
}

std::string verdict(const Fault& fault, const Report& result) {
  if (!result.broken.empty()) return result.broken;
  if (result.invented > 0) return "sentences were taken that nobody sent";
  if (!(result.error_m <= fault.allowed_error_m)) {
    return "the estimate ends " + std::to_string(result.error_m) + " m off";
  }
  const auto heard = [&](std::string_view part, double within) {
    return std::any_of(result.heard.begin(), result.heard.end(), [&](const Line& line) {
      return line.words.find(part) != std::string::npos && line.after_s >= 0.0 && line.after_s <= within;
    });
  };
  switch (fault.expect) {
    case Expect::nothing: return result.heard.empty() ? "" : "the wearer hears: " + result.heard.front().words;
    case Expect::belt_lost: return heard("disconnected", 2.0) ? "" : "the wearer does not hear that the belt is gone";
    case Expect::sensor_blocked:
      return heard("blocked", 10.0) ? "" : "the wearer does not hear which sensor is blocked";
    case Expect::anything: break;
  }
  return "";
}

}  // namespace echoway::faults
