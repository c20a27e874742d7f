#include <array>
#include <cmath>
#include <string>
#include <variant>

#include "echoway/belt/sentence.hpp"
#include "echoway/session.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"
#include "reader.hpp"
#include "target.hpp"

namespace echoway::fuzz {
namespace {

using plans::broken_promise;

/// Keeps one input short: while the building is searched a call costs milliseconds under the sanitizers.
constexpr int kMostCalls = 120;

Start any_start(Reader& in) {
  Start start;
  const std::uint8_t what = in.byte();
  if ((what & 1) != 0) start.room = static_cast<RoomIndex>(in.byte() % 8) - 2;
  if ((what & 2) != 0) start.position = Vec2{in.number(), in.number()};
  if ((what & 4) != 0) start.heading = in.number();
  return start;
}

SessionConfig any_config(Reader& in) {
  SessionConfig config;
  const std::uint8_t what = in.byte();
  config.method = (what & 1) != 0 ? Method::thesis : Method::bayes;
  if ((what & 2) != 0) config.belt.sensors = in.byte();
  if ((what & 4) != 0) config.belt.radius_m = in.number();
  if ((what & 8) != 0) config.belt.beam_rad = in.number();
  if ((what & 16) != 0) config.belt.slot_s = in.number();
  if ((what & 32) != 0) config.belt.max_range_m = in.number();
  if ((what & 64) != 0) config.belt.range_noise = in.number();
  if ((what & 128) != 0) config.belt.temperature_c = in.number();
  config.start = any_start(in);
  config.seed = in.word();
  return config;
}

/// A clock that mostly walks on, and now and then stands, jumps or breaks.
class Clock {
 public:
  double next(Reader& in) {
    const std::uint8_t how = in.byte();
    if (how >= 16) return now_ += 0.001 * how;
    if (how >= 12) return now_ -= in.number();
    if (how >= 4) return now_;
    return how == 0 ? in.number() : std::array{0.0, 1e300, 1e18, -1e300}[how];
  }

 private:
  double now_ = 0.0;
};

void send(Session& session, const Sentence& sentence, double arrival) {
  const EncodedSentence encoded = encode(sentence);
  session.on_bytes({reinterpret_cast<const std::uint8_t*>(encoded.text().data()), encoded.text().size()}, arrival);
}

Goal any_goal(Reader& in) {
  Goal goal;
  goal.kind = static_cast<Goal::Kind>(in.byte() % 5);
  goal.index = static_cast<std::int32_t>(in.byte() % 8) - 2;
  goal.spot = {static_cast<RoomIndex>(in.byte() % 8) - 2, {in.number(), in.number()}};
  return goal;
}

std::string any_name(Reader& in) {
  const auto bytes = in.bytes(in.byte() % 16);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What the wearer wants. Each may be refused, with words.
Status ask(Session& session, Reader& in) {
  const std::uint8_t what = in.byte();
  const RoutePreferences preferences{.avoid_stairs = (what & 128) != 0};
  switch (what % 8) {
    case 0: return session.set_destination(any_name(in), preferences);
    case 1: return session.set_destination("way out", preferences);
    case 2: return session.set_destination(any_goal(in), preferences);
    case 3: return session.way_out(preferences);
    case 4: return session.back_track();
    case 5: session.clear_destination(); break;
    case 6: session.where_am_i(); break;
    default: static_cast<void>(session.repeat());
  }
  return std::monostate{};
}

void call(Session& session, Reader& in, Clock& clock) {
  const std::uint8_t what = in.byte();
  const double time = clock.next(in);
  switch (what % 14) {
    case 0:
    case 1:
    case 2: session.on_firing({time, in.byte() % 16, static_cast<double>(in.byte()) / 24.0}); break;
    case 3: session.on_firing({time, static_cast<int>(in.byte()) - 8, in.number()}); break;
    case 4: session.on_motion({time, static_cast<MotionKind>(in.byte() % 3), in.number()}); break;
    case 5: session.on_bytes(in.bytes(in.byte()), time); break;
    case 6: send(session, EchoSentence{in.word(), static_cast<std::uint8_t>(in.byte() % kMaxSensors), in.word()}, time); break;
    case 7: send(session, RangeSentence{in.word(), static_cast<std::uint8_t>(in.byte() % kMaxSensors), in.word()}, time); break;
    case 8: send(session, StatusSentence{in.byte() % kMaxSensors + 1, {}, in.word() % 1000, in.word()}, time); break;
    case 9: session.on_tick(time); break;
    case 10: (in.byte() % 2 == 0) ? session.on_belt_attached(time) : session.on_belt_detached(time); break;
    case 11: static_cast<void>(session.restart(any_start(in))); break;
    default: static_cast<void>(ask(session, in));
  }
}

/// Two closets with everything that guidance can lead to or along.
Building guided_closets() {
  Building building = plans::two_closets();
  building.exits = {{0, {0.0, 1.0}, "way out"}};
  building.places = {{1, {1.5, 1.0}, "shelf"}};
  building.links = {{LevelLinkKind::stairs, 0, {0.6, 2.0}, 1, {2.0, 0.6}}};
  return building;
}

}  // namespace

std::string session(Bytes data) {
  Reader in(data);
  const SessionConfig config = any_config(in);
  auto opened = Session::open(guided_closets(), config);
  if (!opened) return opened.error().message.empty() ? "an error without words" : "";
  Session& running = **opened;
  if (std::string broken = broken_promise(running); !broken.empty()) return broken + " (at the start)";
  Clock clock;
  for (int i = 0; i < kMostCalls && !in.empty(); ++i) {
    call(running, in, clock);
    if (std::string broken = broken_promise(running); !broken.empty()) return broken;
    if (std::string broken = plans::broken_guidance(running); !broken.empty()) return broken;
  }
  return plans::broken_explanation(running);
}

}  // namespace echoway::fuzz
