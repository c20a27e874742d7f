#include "session_calls.hpp"

#include "echoway/belt/sentence.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"
#include "reader.hpp"
#include "starts.hpp"
#include "wishes.hpp"

namespace echoway::fuzz {
namespace {

using plans::broken_promise;

SessionConfig any_config(Reader& in, Method method) {
  SessionConfig config;
  config.method = method;
  const std::uint8_t what = in.byte();
  if ((what & 1) != 0) config.belt.min_range_m = in.number();
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

void send(Session& session, const Sentence& sentence, double arrival) {
  const EncodedSentence encoded = encode(sentence);
  session.on_bytes({reinterpret_cast<const std::uint8_t*>(encoded.text().data()), encoded.text().size()}, arrival);
}

StatusSentence any_status(Reader& in) {
  StatusSentence status;
  const std::uint8_t what = in.byte();
  const int temperature = in.word();
  const int battery = in.word();
  if (what < 192) status.sensors = what % kMaxSensors + 1;
  if (what < 224) status.temperature_dc = temperature < 1000 ? temperature : temperature % 3001 - 1000;
  if (what < 240) status.battery_mv = battery;
  status.firmware[0] = static_cast<char>('a' + what % 26);
  return status;
}

/// One call with a firing in it; returns how many it had.
int fire(Session& session, Reader& in, std::uint8_t how, double time) {
  switch (how) {
    case 3: session.on_firing({time, static_cast<int>(in.byte()) - 8, in.number()}); break;
    case 5: return session.on_bytes(in.bytes(in.byte()), time);
    case 6:
      send(session, EchoSentence{in.word(), static_cast<std::uint8_t>(in.byte() % kMaxSensors), in.word()}, time);
      break;
    case 7:
      send(session, RangeSentence{in.word(), static_cast<std::uint8_t>(in.byte() % kMaxSensors), in.word()}, time);
      break;
    default: session.on_firing({time, in.byte() % 16, static_cast<double>(in.byte()) / 24.0});
  }
  return 1;
}

void attach(Session& session, Reader& in, double time) {
  (in.byte() % 2 == 0) ? session.on_belt_attached(time) : session.on_belt_detached(time);
}

/// Returns which promise the call broke by itself.
std::string call(Session& session, Reader& in, Clock& clock, Allowance& left) {
  const std::uint8_t what = in.byte() % 16;
  const double time = clock.next(in);
  switch (what) {
    case 4: session.on_motion({time, static_cast<MotionKind>(in.byte() % 3), in.number()}); break;
    case 8: send(session, any_status(in), time); break;
    case 9: session.on_tick(time); break;
    case 10: attach(session, in, time); break;
    case 11:
      if (left.restarts-- > 0) static_cast<void>(session.restart(any_start(in)));
      break;
    case 12:
    case 13: static_cast<void>(ask(session, in)); break;
    case 14: send(session, FaultSentence{static_cast<std::uint8_t>(in.byte() % kMaxSensors), in.word()}, time); break;
    case 15: return plans::broken_explanation(session);
    default:
      if (left.firings > 0) left.firings -= fire(session, in, what, time);
  }
  return "";
}

}  // namespace

std::string drive_session(Bytes data, Method method, Allowance left) {
  Reader in(data);
  const SessionConfig config = any_config(in, method);
  auto opened = Session::open(plans::guided_closets(), config);
  if (!opened) return opened.error().message.empty() ? "an error without words" : "";
  Session& running = **opened;
  if (std::string broken = broken_promise(running); !broken.empty()) return broken + " (at the start)";
  Clock clock;
  for (; left.calls > 0 && !in.empty(); --left.calls) {
    if (std::string broken = call(running, in, clock, left); !broken.empty()) return broken;
    if (std::string broken = broken_promise(running); !broken.empty()) return broken;
    if (std::string broken = plans::broken_guidance(running); !broken.empty()) return broken;
  }
  return plans::broken_explanation(running);
}

}  // namespace echoway::fuzz
