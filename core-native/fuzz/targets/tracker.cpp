// The tracker with few particles, for as long as it takes to be lost, to search and to find again.
#include <algorithm>
#include <string>

#include "echoway/tracker/bayes_locator.hpp"
#include "plans/plans.hpp"
#include "plans/session_promises.hpp"
#include "reader.hpp"
#include "starts.hpp"
#include "target.hpp"
#include "wishes.hpp"

namespace echoway::fuzz {
namespace {

constexpr int kMostCalls = 400;
constexpr int kMostFirings = 120;

BayesOptions any_options(Reader& in) {
  BayesOptions options;
  options.seed = in.byte();
  options.particles = 1 + in.byte() % 24;
  options.particles_without_gyroscope = 1 + in.byte() % 24;
  return options;
}

void call(BayesLocator& tracker, Reader& in, Clock& clock, int& firings) {
  const std::uint8_t what = in.byte() % 16;
  const double time = clock.next(in);
  switch (what) {
    case 0: tracker.on_motion({time, static_cast<MotionKind>(in.byte() % 3), in.number()}); break;
    case 1: tracker.on_motion({time, MotionKind::step, 1.0}); break;
    case 2:
    case 3: tracker.on_motion({time, MotionKind::yaw_rate, 0.02 * (in.byte() - 128)}); break;
    case 4: tracker.on_temperature(in.number()); break;
    case 5: tracker.on_level_transition({0, in.byte() % 2, in.byte() % 2, time, in.number()}); break;
    case 6: ++firings, tracker.on_firing({time, static_cast<int>(in.byte()) - 8, in.number()}); break;
    default: ++firings, tracker.on_firing({time, in.byte() % 15, static_cast<double>(in.byte()) / 24.0});
  }
}

}  // namespace

std::string tracker(Bytes data) {
  static const Building building = plans::guided_closets();
  Reader in(data);
  Start start = any_start(in);
  if (start.room) start.room = *start.room & 1;  // The session refuses rooms that there are not,
  if (start.position && !is_finite(*start.position)) start.position.reset();
  if (start.heading && !std::isfinite(*start.heading)) start.heading.reset();  // and what is no number.
  BayesLocator tracker(building, BeltConfig{}, start, any_options(in));
  Clock clock;
  int firings = 0;
  for (int i = 0; i < kMostCalls && firings < kMostFirings && !in.empty(); ++i) {
    call(tracker, in, clock, firings);
    if (std::string broken = plans::broken_promise(tracker, building); !broken.empty()) return broken;
  }
  return "";
}

}  // namespace echoway::fuzz
