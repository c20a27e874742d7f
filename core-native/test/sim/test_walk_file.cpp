#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "echoway/building/loader.hpp"
#include "echoway/sim/walk_file.hpp"
#include "sim/rooms.hpp"
#include "support/temp_dir.hpp"

namespace echoway::sim {
namespace {

std::string error_of(const std::string& text) {
  const Result<Walk> walk = parse_walk(text, "round.walk");
  return walk.ok() ? "no error" : walk.error().to_string();
}

TEST(WalkFile, ReadsEveryKeyword) {
  const Result<Walk> walk = parse_walk(R"(# A round
building ../lab
seed 77
units ft
profile hard
world dropout 0.25
belt sensors 12
start hall 10 5 90
speed 2
to office 1 2     # through the door
pause 3
turn -90
face 180
speed 1.5
teleport store 3 4 45
cover all 60
cover 0,1,11 20
dead 4
stuck 5,6 4
mend 4
close hall office
open hall office
lights hall on
)",
                                       "round.walk");
  ASSERT_TRUE(walk.ok()) << walk.error().to_string();
  EXPECT_EQ(walk->building, "../lab");
  EXPECT_EQ(walk->seed, 77U);
  EXPECT_EQ(walk->world.dropout, 0.25);
  EXPECT_EQ(walk->world.ghost, make_world(Profile::hard).ghost);
  EXPECT_EQ(walk->belt.sensors, 12);
  EXPECT_NEAR(walk->start.at.x, 3.048, 1e-12);
  EXPECT_NEAR(walk->start_heading, kPi / 2.0, 1e-12);
  EXPECT_NEAR(walk->speed_mps, 0.6096, 1e-12);
  ASSERT_EQ(walk->steps.size(), 14U);
  EXPECT_EQ(walk->steps[0].line, 10);
  EXPECT_EQ(std::get<GoTo>(walk->steps[0].action).to.room, "office");
  EXPECT_NEAR(std::get<SetSpeed>(walk->steps[4].action).mps, 0.4572, 1e-12);
  EXPECT_TRUE(std::get<Cover>(walk->steps[6].action).sensors.empty());
  EXPECT_EQ(std::get<Cover>(walk->steps[7].action).sensors, (std::vector<int>{0, 1, 11}));
  EXPECT_NEAR(std::get<SensorFault>(walk->steps[9].action).range_m, 1.2192, 1e-12);
  EXPECT_FALSE(std::get<SetDoor>(walk->steps[11].action).open);
}

TEST(WalkFile, SaysWhereAndWhatIsWrong) {
  using testing::HasSubstr;
  using testing::StartsWith;
  EXPECT_THAT(error_of(""), HasSubstr("round.walk: the walk has no start"));
  EXPECT_THAT(error_of("to 1 2 3\n"), StartsWith("round.walk:1: `to` comes before `start"));
  EXPECT_THAT(error_of("start 1 2 3 0\n\nto 1 2\n"), StartsWith("round.walk:3: `to` lacks y"));
  EXPECT_THAT(error_of("start 1 2 x 0\n"), HasSubstr("round.walk:1: `x` is no number (y)"));
  EXPECT_THAT(error_of("start 1 2 nan 0\n"), HasSubstr("is no number"));
  EXPECT_THAT(error_of("start 1 2 3 0 9\n"), HasSubstr("one word too many"));
  EXPECT_THAT(error_of("start 1 2 3 0\nstart 1 2 3 0\n"), StartsWith("round.walk:2: the walk has started already"));
  EXPECT_THAT(error_of("start 1 2 3 0\nfly 1\n"), HasSubstr("`fly` is no keyword"));
  EXPECT_THAT(error_of("start 1 2 3 0\npause -1\n"), HasSubstr("seconds must be from 0 to"));
  EXPECT_THAT(error_of("start 1 2 3 0\ncover 0,15 3\n"), HasSubstr("`15` is no sensor of this belt"));
  EXPECT_THAT(error_of("start 1 2 3 0\ncover 0,,1 3\n"), HasSubstr("`` is no sensor"));
  EXPECT_THAT(error_of("start 1 2 3 0\nlights 1 maybe\n"), HasSubstr("on or off"));
  EXPECT_THAT(error_of("world gravity 9.8\n"), HasSubstr("no parameter `gravity`"));
  EXPECT_THAT(error_of("world dropout 1.5\n"), HasSubstr("dropout must be from 0 to 1"));
  EXPECT_THAT(error_of("world dropout 0.5\nprofile hard\n"), HasSubstr("`profile` must come before"));
  EXPECT_THAT(error_of("profile posh\n"), HasSubstr("empty, furnished or hard"));
  EXPECT_THAT(error_of("seed -3\n"), HasSubstr("whole number"));
  EXPECT_THAT(error_of("seed 99999999999999999999\n"), HasSubstr("too large"));
  EXPECT_THAT(error_of("belt sensors 2.5\n"), HasSubstr("whole number"));
  EXPECT_THAT(error_of("units yards\n"), HasSubstr("m or ft"));
}

TEST(WalkFile, RefusesWhatIsAboutTheWholeWalkOnceItHasStarted) {
  for (const std::string line :
       {"building ..", "seed 7", "units ft", "profile hard", "world dropout 0.1", "belt sensors 12"}) {
    const std::string keyword = line.substr(0, line.find(' '));
    EXPECT_EQ(error_of("start 1 2 3 0\n" + line + "\n"),
              "round.walk:2: `" + keyword + "` is about the whole walk; put it before `start`");
    EXPECT_EQ(error_of(line + "\nstart 1 2 3 0\n"), "no error");
  }
}

TEST(WalkFile, ErrorsOfTheWalkItselfNameTheirLine) {
  const Result<Walk> walk = parse_walk("start hall 1 1 0\nto office 1 1\nto cellar 1 1\n", "round.walk");
  ASSERT_TRUE(walk.ok());
  const Result<Simulation> run = simulate(three_rooms(), *walk);
  ASSERT_FALSE(run.ok());
  EXPECT_THAT(run.error().to_string(), testing::StartsWith("round.walk:3: there is no room cellar"));
}

TEST(WalkFile, NoTextMakesItCrash) {
  const std::string good =
      "seed 7\nprofile hard\nworld dropout 0.1\nstart hall 1 1 0\nto office 1 1\ncover 0,3 5\nstuck 4 1\nturn 90\n";
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size()));
      if (random.uniform() < 0.3) {
        text.erase(at, 1 + random.next() % 5);
      } else {
        text[at] = static_cast<char>(random.next() % 256);
      }
    }
    const Result<Walk> walk = parse_walk(text, "round.walk");
    EXPECT_TRUE(walk.ok() || walk.error().file == "round.walk");
  }
}

TEST(WalkFile, IsReadBackAsItWasWritten) {
  Random random(4);
  Walk walk;
  walk.seed = 12;
  walk.start = {"hall", {1.25, 2.5}};
  walk.start_heading = degrees(30.0);
  walk.world = random_world(Profile::hard, random);
  walk.belt.sensors = 12;
  walk.add(GoTo{{"office", {1.0, 2.0}}});
  walk.add(Teleport{{"store", {2.0, 1.0}}, degrees(-90.0)});
  walk.add(Cover{{}, 60.0});
  walk.add(SensorFault{SensorFault::Kind::stuck, {3, 4}, 1.5});
  walk.add(SetDoor{"hall", "office", true});
  walk.add(SetLights{"hall", false});
  const std::string text = format_walk(walk);
  const Result<Walk> back = parse_walk(text, "copy.walk");
  ASSERT_TRUE(back.ok()) << back.error().to_string();
  EXPECT_EQ(format_walk(*back), text);
  EXPECT_EQ(back->steps.size(), walk.steps.size());
  EXPECT_NEAR(back->world.transducer_radius_m, walk.world.transducer_radius_m, 1e-9);
}

TEST(WalkFile, AFileThatIsNotThereIsAnErrorWithItsName) {
  const Result<Walk> walk = read_walk("no/such.walk");
  ASSERT_FALSE(walk.ok());
  EXPECT_THAT(walk.error().to_string(), testing::StartsWith("no/such.walk: "));
}

TEST(WalkFile, AnotherProfileTakesThePlaceOfTheNamedOneButNotOfWorldLines) {
  const test::TempDir folder;
  const auto file = folder.write("w.walk", "profile furnished\nworld dropout 0.2\nstart 1 6 5 90\n");
  const Result<Walk> walk = read_walk(file, Profile::hard);
  ASSERT_TRUE(walk.ok()) << walk.error().to_string();
  EXPECT_EQ(walk->world.people_per_100m2, make_world(Profile::hard).people_per_100m2);
  EXPECT_EQ(walk->world.dropout, 0.2);
  EXPECT_EQ(read_walk(folder.write("p.walk", "profile posh\nstart 1 6 5 90\n"), Profile::hard).error().line, 1);
}

TEST(WalkFile, AFileMayComeFromAnySystemButMustBeText) {
  const test::TempDir folder;
  const auto read = [&](const std::string& text) { return read_walk(folder.write("w.walk", text)); };
  EXPECT_TRUE(read("\xEF\xBB\xBFunits ft\r\nstart 1 6 5 90\r\npause 1").ok());
  EXPECT_THAT(read(std::string("start 1 6 5 9\0\n", 15)).error().to_string(),
              testing::HasSubstr("w.walk:1: holds control"));
}

TEST(WalkFile, EveryWalkThatComesWithAMapCanBeWalked) {
  int walks = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ECHOWAY_MAPS_DIR)) {
    if (entry.path().extension() != ".walk") continue;
    const Result<Walk> walk = read_walk(entry.path());
    ASSERT_TRUE(walk.ok()) << walk.error().to_string();
    const Result<Building> building = load_building(entry.path().parent_path() / walk->building);
    ASSERT_TRUE(building.ok()) << building.error().to_string();
    const Result<Simulation> run = simulate(*building, *walk);
    EXPECT_TRUE(run.ok()) << run.error().to_string();
    ++walks;
  }
  EXPECT_GE(walks, 8);
}

TEST(WalkFile, TheGuideExplainsEveryParameterOfTheWorld) {
  const std::string guide = test::read_text(std::filesystem::path(ECHOWAY_DOCS_DIR) / "simulator.md");
  std::set<std::string_view> names;
  for (const WorldParameter& parameter : world_parameters()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " is listed twice";
    EXPECT_NE(guide.find("`" + std::string(parameter.name) + "`"), std::string::npos) << parameter.name;
    for (const Profile profile : {Profile::empty, Profile::furnished, Profile::hard}) {
      const double value = parameter.get(make_world(profile));
      EXPECT_GE(value, parameter.low) << parameter.name;
      EXPECT_LE(value, parameter.high) << parameter.name;
    }
  }
}

}  // namespace
}  // namespace echoway::sim
