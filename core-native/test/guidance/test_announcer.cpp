// The one voice: what it says twice, and what it does not.
#include "guidance/announcer.hpp"

#include <gtest/gtest.h>

#include "echoway/units.hpp"

namespace echoway::guidance {
namespace {

Cue door_to_the_right(int index, double distance_m) {
  Cue cue = make_cue(CueKind::door);
  cue.has_direction = true;
  cue.direction = -kPi / 2.0;
  cue.distance_m = distance_m;
  cue.landmark = {CueLandmark::Kind::door, index};
  return cue;
}

TEST(Announcer, AnotherDoorInTheSameWordsIsSaidTwiceOnlyWhenAsked) {
  const GuideConfig config;
  Announcer voice(config);
  ASSERT_TRUE(voice.offer(door_to_the_right(0, feet(6.0)), 0.0));
  EXPECT_FALSE(voice.offer(door_to_the_right(1, feet(6.0)), 5.0))
      << "nobody can tell the two doors apart by these words";
  EXPECT_TRUE(voice.offer(door_to_the_right(1, feet(4.0)), 6.0)) << "nearer, in other words";
  EXPECT_TRUE(voice.offer(door_to_the_right(1, feet(4.0)), 9.0, true)) << "asked";
  EXPECT_TRUE(voice.offer(door_to_the_right(2, feet(6.0)), 9.0 + config.repeat_gap_s));
}

TEST(Announcer, AnotherPlaceHasItsOwnWords) {
  const GuideConfig config;
  Announcer voice(config);
  Cue place = make_cue(CueKind::place);
  place.has_direction = true;
  place.landmark = {CueLandmark::Kind::place, 0};
  ASSERT_TRUE(voice.offer(place, 0.0));
  EXPECT_FALSE(voice.offer(place, 5.0));
  place.landmark.index = 1;
  EXPECT_TRUE(voice.offer(place, 5.0));
}

}  // namespace
}  // namespace echoway::guidance
