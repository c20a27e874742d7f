#include "echoway/speech/speaker.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "support/plans.hpp"

namespace echoway {
namespace {

using ::testing::Not;
using ::testing::HasSubstr;

Building plan() {
  Building b;
  b.rooms.push_back(test::make_box("4", 8, 6, "Seminar room"));
  b.rooms.push_back(test::make_box("2", 8, 6, "corridor"));
  b.rooms[1].level = 2;
  b.places.push_back({0, {1, 1}, "Lectern"});
  b.places.push_back({0, {8, 3}, "the window wall"});
  b.exits.push_back({1, {1, 1}, ""});
  b.links.push_back({LevelLinkKind::stairs, 0, {1, 1}, 1, {1, 1}});
  b.links.push_back({LevelLinkKind::elevator, 0, {1, 1}, 1, {1, 1}});
  return b;
}

Cue at(CueKind kind, double direction_deg, double metres = -1.0) {
  Cue cue = make_cue(kind);
  cue.direction = degrees(direction_deg);
  cue.has_direction = true;
  cue.distance_m = metres;
  return cue;
}

Cue with_landmark(Cue cue, CueLandmark::Kind kind, int index) {
  cue.landmark = {kind, index};
  return cue;
}

class SpeakerTest : public ::testing::Test {
 protected:
  std::string say(const Cue& cue) const { return Speaker(building, style).say(cue); }

  Building building = plan();
  SpeechStyle style;
};

TEST_F(SpeakerTest, SaysTheReferenceLines) {
  Cue here = make_cue(CueKind::room_here);
  here.room = 0;
  EXPECT_EQ(say(here), "Room 4, Seminar room.");
  EXPECT_EQ(say(with_landmark(make_cue(CueKind::facing), CueLandmark::Kind::place, 1)), "Facing the window wall.");
  EXPECT_EQ(say(at(CueKind::door, 180, feet(8))), "Door behind you, eight feet.");
  Cue entering = make_cue(CueKind::entering);
  entering.room = 1;
  EXPECT_EQ(say(entering), "Room 2, corridor.");
  EXPECT_EQ(say(at(CueKind::door, -90, feet(6))), "Door right, six feet.");
  EXPECT_EQ(say(at(CueKind::turn, 90)), "Turn left.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, feet(20))), "Go straight, twenty feet.");
  EXPECT_EQ(say(with_landmark(at(CueKind::arrived, -80), CueLandmark::Kind::place, 0)),
            "Arrived: Lectern, on your right.");
  Cue stairs = at(CueKind::stairs, 5, feet(5));
  stairs.up = true;
  stairs.count = 8;
  EXPECT_EQ(say(stairs), "Stairs up ahead, five feet. Eight steps.");
  stairs.count = 0;
  EXPECT_EQ(say(stairs), "Stairs up ahead, five feet.");
  EXPECT_EQ(say(at(CueKind::obstacle, 0, feet(3))), "Something ahead, three feet.");
  EXPECT_EQ(say(make_cue(CueKind::uncertain)), "Not sure where you are. Stop and turn slowly.");
  EXPECT_EQ(say(at(CueKind::sensor_blocked, 48)), "Front left sensor blocked.");
  EXPECT_EQ(say(make_cue(CueKind::belt_lost)), "Belt disconnected.");
  EXPECT_EQ(say(make_cue(CueKind::belt_back)), "Belt connected.");
  EXPECT_EQ(say(make_cue(CueKind::battery_low)), "Belt battery low.");
}

TEST_F(SpeakerTest, FusesTwoFactsIntoOneBreath) {
  Cue wrong = make_cue(CueKind::wrong_way);
  wrong.tail = {CueKind::turn, true, kPi, -1.0};
  EXPECT_EQ(say(wrong), "Wrong way. Turn around.");
  Cue route = make_cue(CueKind::rerouted);
  route.tail = {CueKind::turn, true, degrees(-90), -1.0};
  EXPECT_EQ(say(route), "New route. Turn right.");
  Cue found = make_cue(CueKind::found);
  found.room = 1;
  building.rooms[1].name.clear();
  found.tail = {CueKind::door, true, degrees(70), -1.0};
  EXPECT_EQ(say(found), "Room 2 again. Door left.");
}

TEST_F(SpeakerTest, TellsDirectionsBySectorClockAndDegrees) {
  const std::vector<std::pair<double, std::string>> sides = {
      {0, "ahead"},    {20, "ahead"},       {21, "slightly left"}, {-45, "slightly right"},
      {46, "left"},    {-120, "right"},     {121, "sharp left"},   {-160, "sharp right"},
      {161, "behind you"}, {-180, "behind you"}};
  for (const auto& [angle, words] : sides) EXPECT_EQ(say(at(CueKind::door, angle)), "Door " + words + ".") << angle;
  style.direction = DirectionStyle::clock;
  EXPECT_EQ(say(at(CueKind::door, -60)), "Door at two o'clock.");
  EXPECT_EQ(say(at(CueKind::door, 90)), "Door at nine o'clock.");
  EXPECT_EQ(say(at(CueKind::door, 4)), "Door at twelve o'clock.");
  EXPECT_EQ(say(at(CueKind::turn, -61)), "Turn to two o'clock.");
  style.direction = DirectionStyle::degrees;
  EXPECT_EQ(say(at(CueKind::door, 43)), "Door left, forty degrees.");
  EXPECT_EQ(say(at(CueKind::turn, -88)), "Turn right, ninety degrees.");
  EXPECT_EQ(say(at(CueKind::door, 2)), "Door ahead.");
}

TEST_F(SpeakerTest, SaysWhatTheWearerIsStoppedBefore) {
  Cue cue = at(CueKind::stop, 0);
  cue.tail = {CueKind::facing, true, 0.0, -1.0};
  EXPECT_EQ(say(cue), "Stop. Facing the wall.");
}

TEST_F(SpeakerTest, RoundsFeetMetresAndSteps) {
  EXPECT_EQ(say(at(CueKind::go_straight, 0, feet(1.2))), "Go straight, one foot.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, feet(9.4))), "Go straight, nine feet.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, feet(13))), "Go straight, fifteen feet.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, feet(123))), "Go straight, one hundred twenty-five feet.");
  style.length = LengthStyle::metres;
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 0.4)), "Go straight, half a metre.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 1.6)), "Go straight, one and a half metres.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 4.4)), "Go straight, four metres.");
  style.length = LengthStyle::steps;
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 0.65)), "Go straight, one step.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 3.2)), "Go straight, five steps.");
}

TEST_F(SpeakerTest, IsNeverMorePreciseThanTheEstimate) {
  Cue cue = at(CueKind::door, 0, feet(7));
  cue.sigma_m = 0.2;
  EXPECT_EQ(say(cue), "Door ahead, seven feet.");
  cue.sigma_m = 0.5;
  EXPECT_EQ(say(cue), "Door ahead, five feet.");
  // Five feet, the least that can be said with that grain, would be more than twice as far.
  cue.distance_m = feet(2);
  EXPECT_EQ(say(cue), "Door ahead, a step or two.");
  cue.distance_m = feet(7);
  cue.sigma_m = 1.0;
  EXPECT_EQ(say(cue), "Door ahead, a few steps.");
  cue.sigma_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(say(cue), "Door ahead, a few steps.");
}

TEST_F(SpeakerTest, CallsARoomByItsNameAloneWhenItsIdIsMadeOfIt) {
  building.rooms.push_back(test::make_box("2-main-corridor", 8, 6, "Main corridor"));
  Cue entering = make_cue(CueKind::entering);
  entering.room = 2;
  EXPECT_EQ(say(entering), "Main corridor.");
}

TEST_F(SpeakerTest, CallsImportedRoomsAsTheirDoorsDo) {
  const auto enter = [&](const char* id, const char* name, Language language) {
    building.rooms.push_back(test::make_box(id, 8, 6, name));
    Cue entering = make_cue(CueKind::entering);
    entering.room = static_cast<RoomIndex>(building.rooms.size()) - 1;
    style.language = language;
    return say(entering);
  };
  EXPECT_EQ(enter("1-room-7", "", Language::english), "Room 7.");
  EXPECT_EQ(enter("g-room-12", "", Language::german), "Raum 12.");
  EXPECT_EQ(enter("1-room-7", "", Language::french), "Salle 7.");
  EXPECT_EQ(enter("2-2-07", "2.07", Language::english), "Room 2.07.");
  EXPECT_EQ(enter("2-b-12", "B 12", Language::german), "Raum B 12.");
  EXPECT_EQ(enter("4", "4", Language::french), "Salle 4.");
  EXPECT_EQ(enter("2-3d-lab", "3D lab", Language::english), "3D lab.");
  EXPECT_EQ(enter("2-wc", "WC", Language::english), "WC.");
  EXPECT_EQ(enter("break-room-b", "", Language::english), "Room break-room-b.");
}

TEST_F(SpeakerTest, NamesLevelsAndUnnamedThings) {
  Cue take = with_landmark(make_cue(CueKind::take_link), CueLandmark::Kind::link, 1);
  take.up = true;
  EXPECT_EQ(say(take), "Take the elevator up to level two.");
  EXPECT_EQ(say(with_landmark(at(CueKind::arrived, 0), CueLandmark::Kind::exit, 0)),
            "Arrived: the exit, ahead of you.");
  EXPECT_EQ(say(make_cue(CueKind::arrived)), "Arrived.");
  EXPECT_EQ(say(with_landmark(make_cue(CueKind::arrived), CueLandmark::Kind::place, 99)), "Arrived: your destination.");
}

TEST_F(SpeakerTest, SpeaksGerman) {
  style.language = Language::german;
  style.length = LengthStyle::metres;
  EXPECT_EQ(say(at(CueKind::door, -90, 1.0)), "Tür rechts, ein Meter.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 21.0)), "Geradeaus, einundzwanzig Meter.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 2.5)), "Geradeaus, zweieinhalb Meter.");
  EXPECT_EQ(say(at(CueKind::turn, 180)), "Umdrehen.");
  style.length = LengthStyle::steps;
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 0.65)), "Geradeaus, ein Schritt.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 1.3)), "Geradeaus, zwei Schritte.");
}

TEST_F(SpeakerTest, SpeaksFrenchWithItsOwnPlural) {
  style.language = Language::french;
  style.length = LengthStyle::metres;
  EXPECT_EQ(say(at(CueKind::door, -90, 1.0)), "Porte à droite, un mètre.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 1.5)), "Tout droit, un mètre et demi.");  // singular below two
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 2.5)), "Tout droit, deux mètres et demi.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 71.0)), "Tout droit, soixante et onze mètres.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 80.0)), "Tout droit, quatre-vingts mètres.");
  EXPECT_EQ(say(at(CueKind::go_straight, 0, 95.0)), "Tout droit, quatre-vingt-quinze mètres.");
  style.direction = DirectionStyle::clock;
  EXPECT_EQ(say(at(CueKind::door, -30)), "Porte à une heure.");
  EXPECT_EQ(say(at(CueKind::turn, -60)), "Tournez à deux heures.");
}

// What stands between blanks and has a letter in it.
int most_words_of_a_sentence(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  int most = 0;
  for (int count = 0; words >> word;) {
    if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) || c > 127; })) ++count;
    most = std::max(most, count);
    if (word.ends_with('.')) count = 0;
  }
  return most;
}

std::vector<SpeechStyle> all_styles() {
  std::vector<SpeechStyle> styles;
  for (const Language language : {Language::english, Language::german, Language::french}) {
    for (const auto direction : {DirectionStyle::sides, DirectionStyle::clock, DirectionStyle::degrees}) {
      for (const auto length : {LengthStyle::feet, LengthStyle::metres, LengthStyle::steps}) {
        styles.push_back({language, direction, length});
      }
    }
  }
  return styles;
}

/// Of every kind, all round, at distances that are told in different words, and as well as vaguely known.
std::vector<Cue> all_cues() {
  std::vector<Cue> cues;
  for (int kind = 0; kind < kCueKinds; ++kind) {
    for (int angle = -170; angle <= 180; angle += 10) {
      for (const double metres : {-1.0, 0.3, 0.5, 0.8, 1.5, 2.5, 6.4, 21.0, 38.0}) {
        Cue cue = with_landmark(at(static_cast<CueKind>(kind), angle, metres), CueLandmark::Kind::place, 0);
        cue.room = 1;
        cue.count = 21;
        cues.push_back(cue);
        cue.sigma_m = 1.0;
        cues.push_back(cue);
      }
    }
  }
  return cues;
}

TEST_F(SpeakerTest, NoSentenceHasMoreThanEightWordsHoweverDirectionsAndLengthsAreTold) {
  const std::vector<Cue> cues = all_cues();
  for (const SpeechStyle& each : all_styles()) {
    style = each;
    for (const Cue& cue : cues) {
      const std::string words = say(cue);
      ASSERT_LE(most_words_of_a_sentence(words), 8) << words;
      ASSERT_THAT(words, Not(HasSubstr("{")));
      ASSERT_THAT(words, Not(HasSubstr("[")));
      ASSERT_EQ(words.back(), '.');
    }
  }
}

TEST_F(SpeakerTest, ALineThatWouldBeTooLongTellsTheSideAndKeepsTheDistance) {
  style.direction = DirectionStyle::clock;
  style.length = LengthStyle::metres;
  EXPECT_EQ(say(at(CueKind::obstacle, -35, 1.5)), "Something slightly right, one and a half metres.");
  EXPECT_EQ(say(at(CueKind::obstacle, -35, 1.0)), "Something at one o'clock, one metre.");
  style.direction = DirectionStyle::degrees;
  EXPECT_EQ(say(at(CueKind::door, -110, 1.5)), "Door right, one and a half metres.");
  EXPECT_EQ(say(at(CueKind::door, -110, 2.0)), "Door right, one hundred ten degrees, two metres.");
  // A name is as long as it is.
  building.places[0].name = "Lectern of the large lecture hall";
  EXPECT_EQ(say(with_landmark(at(CueKind::place, -80, 2.0), CueLandmark::Kind::place, 0)),
            "Lectern of the large lecture hall right, eighty degrees, two metres.");
}

TEST(LanguageOf, TakesTagsAndRefusesUnknownOnes) {
  EXPECT_EQ(*language_of("en"), Language::english);
  EXPECT_EQ(*language_of("de-AT"), Language::german);
  EXPECT_EQ(*language_of("FR_ca"), Language::french);
  const auto none = language_of("eo");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("en, de and fr"));
}

}  // namespace
}  // namespace echoway
