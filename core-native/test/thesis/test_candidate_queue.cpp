#include "thesis/candidate_queue.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace echoway::thesis {
namespace {

Match match_of(double quality) {
  Match match;
  match.found = true;
  match.quality = quality;
  return match;
}

TEST(UpdatedLikelihood, AveragesWhenTheCurrentRoomMatchesBetter) {
  // (5.2): CR 0.1, NR 0.3: (0.5 + 0.1/0.4)/2 = 0.375.
  EXPECT_DOUBLE_EQ(updated_likelihood(0.5, 0.1, 0.3), 0.375);
}

TEST(UpdatedLikelihood, AddsUpWhenTheCandidateMatchesBetter) {
  // (5.3), (5.4): CR 0.3, NR 0.1: pNew = 0.75; 0.5 + 0.75 - 0.375 = 0.875.
  EXPECT_DOUBLE_EQ(updated_likelihood(0.5, 0.3, 0.1), 0.875);
}

TEST(UpdatedLikelihood, StaysAProbability) {
  for (const double p : {0.0, 0.3, 1.0}) {
    for (const double a : {0.0, 1e-300, 0.5, 1.0}) {
      for (const double b : {0.0, 1e-300, 0.5, 1.0}) {
        const double updated = updated_likelihood(p, a, b);
        EXPECT_GE(updated, 0.0);
        EXPECT_LE(updated, 1.0);
      }
    }
  }
}

TEST(CandidateQueue, EntersAfterTwoBetterMatches) {
  CandidateQueue queue({}, 5);
  queue.add(3);
  queue.candidates()[0].match = match_of(0.1);
  queue.update(match_of(0.15));  // 0.15/0.25 = 0.6
  EXPECT_EQ(queue.entered(), nullptr);
  queue.update(match_of(0.15));  // 0.6 + 0.6 - 0.36 = 0.84, above 80 %
  ASSERT_NE(queue.entered(), nullptr);
  EXPECT_EQ(queue.entered()->room, 3);
}

TEST(CandidateQueue, ComparesObjectivesThemselvesWhenAsked) {
  // A hallway with 10 m of range off by 0.3 m, an office with 4 m of range off by 0.2 m: over their ranges the hallway
  // is better, by themselves the office.
  Match hallway = match_of(0.03);
  hallway.objective_m = 0.3;
  Match office = match_of(0.05);
  office.objective_m = 0.2;
  for (const bool by_range : {true, false}) {
    ThesisParameters parameters;
    parameters.compare_by_range = by_range;
    CandidateQueue queue(parameters, 5);
    queue.add(3);
    queue.candidates()[0].match = office;
    queue.update(hallway);
    queue.update(hallway);
    EXPECT_EQ(queue.entered() != nullptr, !by_range);
  }
}

TEST(CandidateQueue, PurgesBelowTenPercentAndMovesTheRestUp) {
  CandidateQueue queue({}, 5);
  queue.add(1);
  queue.add(2);
  queue.add(1);
  ASSERT_EQ(queue.candidates().size(), 2U);
  queue.candidates()[0].match = match_of(0.9);  // (0 + 0.1/1.0)/2 = 5 %
  queue.candidates()[1].match = match_of(0.1);
  queue.update(match_of(0.1));
  queue.purge();
  ASSERT_EQ(queue.candidates().size(), 1U);
  EXPECT_EQ(queue.candidates()[0].room, 2);
}

TEST(CandidateQueue, NeverEntersARoomThatNothingMatchesIn) {
  CandidateQueue queue({}, 2);
  queue.add(1);
  for (int i = 0; i < 20; ++i) queue.update(Match{});  // neither room matches
  EXPECT_EQ(queue.entered(), nullptr);
}

}  // namespace
}  // namespace echoway::thesis
