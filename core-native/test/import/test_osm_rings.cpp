#include "source/osm_rings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echoway::import {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Ways = std::vector<std::vector<OsmId>>;

TEST(OsmRings, AClosedWayIsOneAsItIsDrawn) {
  const OsmRings joined = join_into_rings({{5, 2, 9, 5}, {1, 3, 4, 1}});
  EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(5, 2, 9), ElementsAre(1, 3, 4)));
  EXPECT_THAT(joined.left_over, IsEmpty());
}

TEST(OsmRings, WaysAreJoinedInAnyOrderWhicheverWayRoundTheyAreDrawn) {
  for (const Ways& ways : {Ways{{1, 2, 3}, {3, 4, 5}, {5, 6, 1}}, Ways{{1, 2, 3}, {1, 6, 5}, {5, 4, 3}}}) {
    const OsmRings joined = join_into_rings(ways);
    EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(1, 2, 3, 4, 5, 6)));
    EXPECT_THAT(joined.left_over, IsEmpty());
  }
}

TEST(OsmRings, ThereAreAsManyAsComeOutInTheOrderOfTheirFirstWays) {
  const OsmRings joined = join_into_rings({{1, 2, 3}, {11, 12, 13}, {21, 22, 23, 21}, {13, 11}, {3, 1}});
  EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(1, 2, 3), ElementsAre(11, 12, 13), ElementsAre(21, 22, 23)));
}

// Two rooms that touch in a corner are no figure of eight.
TEST(OsmRings, ThatTouchInANodeStayTwo) {
  const OsmRings joined = join_into_rings({{1, 2, 9}, {9, 11, 12}, {12, 13, 9}, {9, 3, 1}});
  EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(1, 2, 9, 3), ElementsAre(9, 11, 12, 13)));
  const OsmRings with_a_closed_one = join_into_rings({{1, 2, 9}, {9, 11, 12, 9}, {9, 3, 1}});
  EXPECT_THAT(with_a_closed_one.rings, ElementsAre(ElementsAre(1, 2, 9, 3), ElementsAre(9, 11, 12)));
}

TEST(OsmRings, AWayThatLeadsNowhereIsLeftOverAndKeepsNoOtherFromClosing) {
  const OsmRings joined = join_into_rings({{7, 1}, {1, 2, 3}, {3, 5, 6}, {6, 8}, {3, 4, 1}, {}});
  EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(1, 2, 3, 4)));
  EXPECT_THAT(joined.left_over, ElementsAre(0, 2, 3, 5));
}

TEST(OsmRings, OfThreeWaysBetweenTwoNodesTheFirstTwoClose) {
  for (const Ways& ways : {Ways{{1, 2, 9}, {1, 3, 9}, {1, 4, 9}}, Ways{{1, 2, 9}, {9, 3, 1}, {9, 4, 1}}}) {
    const OsmRings joined = join_into_rings(ways);
    EXPECT_THAT(joined.rings, ElementsAre(ElementsAre(1, 2, 9, 3)));
    EXPECT_THAT(joined.left_over, ElementsAre(2));
  }
}

TEST(OsmRings, HaveThreeCornersOrMore) {
  const OsmRings joined = join_into_rings({{1, 2}, {2, 1}, {3, 4, 3}, {5}, {6, 6}});
  EXPECT_THAT(joined.rings, IsEmpty());
  EXPECT_THAT(joined.left_over, ElementsAre(0, 1, 2, 3, 4));
}

}  // namespace
}  // namespace echoway::import
