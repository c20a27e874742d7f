// What holds of every command: help, usage, options, where words go.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace echoway {
namespace {

using test::ProcessResult;
using test::run_echoway;
using test::TemporaryFolder;
using Arguments = std::vector<std::string>;

const std::string kLab = std::string(ECHOWAY_MAPS_DIR) + "/torgersen-lab";
const std::string kWalk = kLab + "/walks/thesis.walk";

/// The command ends with 2 and says `why`.
void expect_refused(const Arguments& arguments, const std::string& why) {
  const ProcessResult result = run_echoway(arguments);
  EXPECT_EQ(result.status, 2) << testing::PrintToString(arguments);
  EXPECT_NE(result.err.find(why), std::string::npos) << testing::PrintToString(arguments) << ": " << result.err;
}

constexpr const char* kCommands[] = {"bench",   "check", "describe", "import",  "locate",
                                     "monitor", "play",  "score",    "simulate"};

TEST(CommandLine, EveryCommandHasHelp) {
  for (const char* command : kCommands) {
    const ProcessResult result = run_echoway({command, "--help"});
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_NE(result.out.find("Usage"), std::string::npos) << command;
  }
}

// Broken by the window, a line of a table is hard to follow, by eye and by ear.
TEST(CommandLine, HelpFitsInAHundredColumns) {
  std::vector<Arguments> all{{"--help"}};
  for (const char* command : kCommands) all.push_back({command, "--help"});
  for (const Arguments& arguments : all) {
    std::istringstream help(run_echoway(arguments).out);
    for (std::string line; std::getline(help, line);) {
      const bool names_the_program = line.starts_with("Usage: ");
      EXPECT_TRUE(line.size() <= 100 || names_the_program) << line;
    }
  }
}

TEST(CommandLine, BadUsageSaysWhatIsWrong) {
  expect_refused({}, "--help");
  expect_refused({"fly"}, "fly");
  expect_refused({"--fly"}, "--fly");
  expect_refused({"locate"}, "--building");
  expect_refused({"check", kLab, "more"}, "more");
  expect_refused({"locate", "--building", kLab, "--scans", "x", "--track", "y", "--track", "z"}, "--track");
  expect_refused({"locate", "--building", "/no/such", "--scans", "x", "--track", "y"}, "/no/such: ");
}

TEST(CommandLine, OptionsHoldDecimalNumbersInTheirRange) {
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--sensors", "0"},
                                                        {"--sensors", "65"},
                                                        {"--sensors", "15.5"},
                                                        {"--sensors", "0x0f"},
                                                        {"--radius", "nan"},
                                                        {"--radius", "-0.1"},
                                                        {"--radius", "0x1p-3"},
                                                        {"--beam", "inf"},
                                                        {"--beam", "wide"},
                                                        {"--seed", "-1"},
                                                        {"--seed", "1.5"},
                                                        {"--seed", "99999999999999999999"},
                                                        {"--seed", ""},
                                                        {"--track", ""},
                                                        {"--scans", ""},
                                                        {"--motion", ""},
                                                        {"--start", ""},
                                                        {"--to", ""}}) {
    Arguments arguments{"locate", option, value};
    for (const char* needed : {"--building", "--scans", "--track"}) {
      if (option != needed) arguments.insert(arguments.end(), {needed, "x"});
    }
    expect_refused(arguments, option + ": ");
  }
  for (const char* seconds : {"nan", "0", "1e9"}) {
    expect_refused({"simulate", "--building", kLab, "--out", "x", "--random", seconds}, "--random: ");
  }
  expect_refused({"simulate", "--building", kLab, "--out", "x", "--at", "y", "--bearings", "0,nan"}, "--bearings: ");
  expect_refused({"simulate", "--building", kLab, "--out", "x", "--random", "5", "--profile", "full"}, "--profile: ");
  expect_refused({"play", "--scans", "x", "--speed", "nan"}, "--speed: ");
}

TEST(CommandLine, AWalkAndARandomWalkExcludeEachOther) {
  expect_refused({"simulate", "--building", kLab, "--walk", kWalk, "--random", "5", "--out", "x"}, "excludes");
}

TEST(CommandLine, WhatOnlyAScanHasIsRefusedBesideAWalk) {
  for (const Arguments& more : {Arguments{"--bearings", "0,90"}, {"--radius", "0.2"}, {"--draw-world"}}) {
    Arguments arguments{"simulate", "--walk", kWalk, "--out", "x"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(arguments, "--at");
  }
}

TEST(CommandLine, AProfileTakesThePlaceOfTheWalksOwn) {
  const TemporaryFolder folder;
  const std::string walk = folder.write("w.walk", "profile hard\nstart 4 1 1 0\npause 2\n").string();
  const auto scans = [&](const Arguments& more, const std::string& name) {
    Arguments arguments{"simulate", "--building", kLab, "--walk", walk, "--out", (folder.path() / name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_echoway(arguments).status, 0);
    return test::read_file((folder.path() / name).string() + ".scans.csv");
  };
  const std::string hard = scans({}, "own");
  EXPECT_EQ(scans({"--profile", "hard"}, "same"), hard);
  EXPECT_NE(scans({"--profile", "empty"}, "other"), hard);
}

TEST(CommandLine, SimulateLeavesNoPieceOfAFileThatItCannotWrite) {
  const TemporaryFolder folder;
  const std::filesystem::path prefix = folder.path() / "walk";
  std::filesystem::create_directory(prefix.string() + ".walk");
  expect_refused({"simulate", "--building", kLab, "--random", "5", "--out", prefix.string()},
                 prefix.string() + ".walk: ");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_TRUE(entry.path().extension() == ".csv" || entry.is_directory()) << entry.path();
  }
}

TEST(CommandLine, APrefixThatIsAFolderIsRefused) {
  const TemporaryFolder folder;
  expect_refused({"simulate", "--building", kLab, "--random", "5", "--out", folder.path().string() + "/"}, "--out ");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(CommandLine, ARoomTooLargeToBeSimulatedIsNamed) {
  const TemporaryFolder folder;
  folder.write("building.cfg", "units m\n");
  folder.write("room-plain.room", "4 0 0\n1 0 0 1e5 0\n1 1e5 0 1e5 1e5\n1 1e5 1e5 0 1e5\n1 0 1e5 0 0\n");
  const std::string stands = folder.write("at.csv", "time_s,room,x_m,y_m,heading_deg\n0,plain,5,5,0\n").string();
  const std::string out = (folder.path() / "x").string();
  expect_refused({"simulate", "--building", folder.path().string(), "--random", "5", "--out", out},
                 "room plain is too large");
  expect_refused({"simulate", "--building", folder.path().string(), "--at", stands, "--out", out},
                 "room plain is too large");
  expect_refused({"bench", "--building", folder.path().string(), "--walks", "1"}, "room plain is too large");
}

TEST(CommandLine, NobodyScansWhereNobodyCanStand) {
  const TemporaryFolder folder;
  const std::string header = "time_s,room,x_m,y_m,heading_deg\n0,4,1,1,0\n";
  const auto expect_line_3_refused = [&](const std::string& stand, const std::string& why) {
    const std::string stands = folder.write("at.csv", header + stand).string();
    expect_refused({"simulate", "--building", kLab, "--at", stands, "--out", (folder.path() / "x").string()},
                   stands + ":3: " + why);
  };
  expect_line_3_refused("1,cellar,1,1,0\n", "there is no room cellar in the building");
  expect_line_3_refused("1,4,100,1,0\n", "the place is not inside room 4");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "x.scans.csv"));
}

TEST(CommandLine, WhatCannotBePrintedIsAnErrorAndNoCrash) {
  const Arguments describe{"describe", kLab};
  EXPECT_EQ(run_echoway(describe, {.out = "/dev/full"}).status, 1);
  EXPECT_NE(run_echoway(describe, {.out = "/dev/full"}).err.find("No space left"), std::string::npos);
  EXPECT_EQ(run_echoway({"--help"}, {.out = "/dev/full"}).status, 1);
  EXPECT_EQ(run_echoway({"check", "/no/such"}, {.err = "/dev/full"}).status, 2);
}

}  // namespace
}  // namespace echoway
