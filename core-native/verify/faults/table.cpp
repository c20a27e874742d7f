#include <algorithm>
#include <utility>

#include "echoway/belt/sentence.hpp"
#include "faults/fault.hpp"

namespace echoway::faults {
namespace {

constexpr double kAnyError = 1e9;

bool during(const Event& event) { return event.time_s >= kBegin && event.time_s < kEnd; }

/// Replaces each n-th byte of all, counted through the whole stream, by what `change` makes of it.
template <class Change>
void change_each(Events& events, int n, Change change) {
  int count = 0;
  for (Event& event : events) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint8_t byte : event.bytes) {
      if (++count % n == 0) {
        change(byte, count, bytes);
      } else {
        bytes.push_back(byte);
      }
    }
    event.bytes = std::move(bytes);
  }
}

/// Decodes every sentence, lets `change` alter it (false: drop it) and encodes it again.
template <class Change>
void change_firings(Events& events, Change change) {
  for (Event& event : events) {
    SentenceDecoder decoder;
    std::vector<Sentence> found;
    decoder.feed(event.bytes, [&](const Sentence& s) { found.push_back(s); });
    if (found.empty()) continue;
    EchoSentence echo = std::get<EchoSentence>(found.front());
    event.bytes.clear();
    if (!change(event, echo)) continue;
    const EncodedSentence encoded = encode(echo);
    event.bytes.assign(encoded.text().begin(), encoded.text().end());
  }
}

void go_silent(Events& events, double from, double until) {
  std::erase_if(events, [=](const Event& e) { return e.time_s >= from && e.time_s < until; });
}

void close_port(Events& events) {
  go_silent(events, kBegin, kEnd);
  const auto at = [&](double time) {
    return std::find_if(events.begin(), events.end(), [=](const Event& e) { return e.time_s >= time; });
  };
  events.insert(at(kEnd), {Event::Kind::attached, kEnd});
  events.insert(at(kBegin), {Event::Kind::detached, kBegin});
}

void restart_numbers(Events& events) {
  std::uint16_t seq = 0;
  change_firings(events, [&](const Event& e, EchoSentence& echo) {
    if (e.time_s >= kBegin) echo.seq = seq++;
    return true;
  });
}

void reboot(Events& events) {
  go_silent(events, kBegin, kBegin + 2.0);
  restart_numbers(events);
}

/// Arrivals stay where they are; what arrives is exchanged.
void reverse_blocks(Events& events, std::size_t block) {
  for (std::size_t i = 0; i + block <= events.size(); i += block) {
    for (std::size_t k = 0; k < block / 2; ++k) std::swap(events[i + k].bytes, events[i + block - 1 - k].bytes);
  }
}

void deafen(Events& events, int sensor) {
  change_firings(events, [=](const Event& e, EchoSentence& echo) {
    if (during(e) && echo.sensor == sensor) echo.tof_us.reset();
    return true;
  });
}

void cover(Events& events, int sensor) {
  change_firings(events, [=](const Event& e, EchoSentence& echo) {
    if (during(e) && echo.sensor == sensor) echo.tof_us = 890;  // 0.153 m, the shortest that a transducer reports
    return true;
  });
}

void skip(Events& events, int sensor) {
  change_firings(events, [=](const Event& e, const EchoSentence& echo) { return !during(e) || echo.sensor != sensor; });
}

/// Everything between the fault's beginning and its end arrives at once at its end.
void stall(Events& events) {
  for (Event& event : events) {
    if (during(event)) event.time_s = kEnd;
  }
}

void add_noise(Events& events) {
  std::uint32_t state = 12345;
  for (Event& event : events) {
    if (!during(event)) continue;
    for (int i = 0; i < 40; ++i) {
      state = state * 1664525U + 1013904223U;
      event.bytes.push_back(static_cast<std::uint8_t>(state >> 24));
    }
  }
}

/// A sentence has about 20 bytes: of those that lose each 20th byte none is left, of those that lose each 100th four in
/// five are. Up to there nothing is promised but that the core neither breaks nor lies.
void add_bytes(std::vector<Fault>& table, int n) {
  const Expect expect = n <= 60 ? Expect::anything : Expect::nothing;
  const double error = n <= 60 ? kAnyError : 1.0;
  const std::string each = "each " + std::to_string(n) + (n == 2 ? "nd" : "th") + " byte ";
  table.push_back({each + "lost", expect, [=](Events& e) { lose_each(e, n); }, error, true});
  table.push_back({each + "doubled", expect, [=](Events& e) { double_each(e, n); }, error, true});
  table.push_back({each + "with one bit flipped", expect, [=](Events& e) { flip_each(e, n); }, error, true});
}

}  // namespace

void lose_each(Events& events, int n) {
  change_each(events, n, [](std::uint8_t, int, std::vector<std::uint8_t>&) {});
}

void double_each(Events& events, int n) {
  change_each(events, n,
              [](std::uint8_t byte, int, std::vector<std::uint8_t>& out) { out.insert(out.end(), 2, byte); });
}

void flip_each(Events& events, int n) {
  change_each(events, n, [](std::uint8_t byte, int count, std::vector<std::uint8_t>& out) {
    out.push_back(static_cast<std::uint8_t>(byte ^ (1U << (static_cast<unsigned>(count / 3) % 8U))));
  });
}

const std::vector<Fault>& table() {
  static const std::vector<Fault> all = [] {
    std::vector<Fault> t;
    t.push_back({"none", Expect::nothing, [](Events&) {}});
    for (const int n : {2, 20, 60, 100, 300, 1000}) add_bytes(t, n);
    t.push_back({"40 bytes of noise after every sentence, for 10 s", Expect::nothing, add_noise, 1.0, true});
    t.push_back({"sentences in pairs the wrong way round", Expect::anything, [](Events& e) { reverse_blocks(e, 2); }});
    t.push_back({"sentences in eights the wrong way round", Expect::anything, [](Events& e) { reverse_blocks(e, 8); },
                 kAnyError});
    t.push_back({"the belt reboots: 2 s of silence, numbers from 0", Expect::belt_lost, reboot});
    t.push_back({"the numbers start over in mid-scan", Expect::nothing, restart_numbers});
    t.push_back({"one sensor hears nothing for 10 s", Expect::anything, [](Events& e) { deafen(e, 1); }});
    t.push_back({"one sensor is covered for 10 s", Expect::sensor_blocked, [](Events& e) { cover(e, 2); }});
    t.push_back({"the belt skips one sensor for 10 s", Expect::sensor_blocked, [](Events& e) { skip(e, 2); }});
    t.push_back({"the port closes for 10 s", Expect::belt_lost, close_port, 1.5});
    t.push_back({"the line goes silent for 10 s, port open", Expect::belt_lost,
                 [](Events& e) { go_silent(e, kBegin, kEnd); }, 1.5});
    t.push_back({"the line stalls for 10 s, then all of it at once", Expect::belt_lost, stall, 1.5});
    return t;
  }();
  return all;
}

}  // namespace echoway::faults
