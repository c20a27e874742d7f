// `echoway monitor` and a belt whose sentences come at another pace than it fired.
#include "tools/live_belt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "echoway/belt/sentence.hpp"
#include "echoway/building/loader.hpp"
#include "echoway/sim/simulate.hpp"
#include "echoway/sim/walk_file.hpp"
#include "echoway/units.hpp"
#include "tracker/play.hpp"

namespace echoway::tools {
namespace {

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";

const sim::Simulation& lab_walk() {
  static const sim::Simulation simulation = [] {
    const Result<sim::Walk> walk = sim::read_walk(kLab + "/walks/thesis.walk");
    return sim::simulate(*load_building(kLab), *walk).value();
  }();
  return simulation;
}

std::string sentences_of(const std::vector<Firing>& firings) {
  const double microseconds_a_metre = 2e6 / speed_of_sound(BeltConfig{}.temperature_c);
  std::string bytes;
  std::uint16_t seq = 0;
  for (const Firing& firing : firings) {
    EchoSentence echo{seq++, static_cast<std::uint8_t>(firing.sensor), {}};
    if (firing.has_echo()) echo.tof_us = static_cast<std::uint32_t>(std::lround(microseconds_a_metre * firing.range_m));
    bytes += encode(echo).text();
  }
  return bytes;
}

struct Followed {
  std::string room;
  TrackState state = TrackState::searching;
  double told_s = 0.0;  ///< How long the walk took, as the session was told.
  int unsure = 0;       ///< How often the wearer heard that they may be elsewhere.
};

/// The walk sent without pauses and read little by little; a busy machine holds the line up for `stall_s` after each
/// third.
Followed follow_rush(double stall_s) {
  const std::string bytes = sentences_of(lab_walk().scans.firings);
  Building lab = load_building(kLab).value();
  const Start start = test::start_of(lab_walk(), lab);
  const std::unique_ptr<Session> session = Session::open(std::move(lab), {.start = start}).value();
  Followed followed;
  double host_s = 0.0;
  LiveBelt belt(*session, [&] { return host_s; }, [&] {
    for (Cue cue; session->next_cue(cue);) followed.unsure += cue.kind == CueKind::uncertain ? 1 : 0;
  });
  belt.attach();
  constexpr std::size_t kRead = 300;
  const std::size_t third = bytes.size() / 3;
  std::size_t thirds = 0;
  for (std::size_t at = 0; at < bytes.size(); at += kRead) {
    host_s += at / third > thirds ? stall_s : 0.001;
    thirds = at / third;
    const auto* begin = reinterpret_cast<const std::uint8_t*>(bytes.data()) + at;
    belt.take({begin, std::min(kRead, bytes.size() - at)});
    belt.tick();
  }
  followed.room = session->building().room(session->estimate().room).id;
  followed.state = session->estimate().state;
  followed.told_s = session->estimate().time_s;
  return followed;
}

// A recording that is sent to the port as fast as it takes it: the wearer did not walk any faster. While the line is
// held up, they stand.
TEST(LiveBelt, AWalkThatComesFarFasterThanABeltFiresIsFollowed) {
  const double walked = lab_walk().truth.back().time_s - lab_walk().truth.front().time_s;
  for (const double stall_s : {0.0, 0.3, 1.0}) {
    SCOPED_TRACE(stall_s);
    const Followed followed = follow_rush(stall_s);
    EXPECT_EQ(followed.room, lab_walk().truth.back().room);
    EXPECT_EQ(followed.state, TrackState::tracking);
    EXPECT_EQ(followed.unsure, 0);
    EXPECT_NEAR(followed.told_s, walked + stall_s, 1.5 + stall_s);
  }
}

}  // namespace
}  // namespace echoway::tools
