#include "echoway/scene/echo_explainer.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/plans.hpp"

namespace echoway {
namespace {

/// A hall of 8 x 6 m with corners, a door to a store on its right, a screen, a bench and a pillar's edge.
Building hall() {
  Building b;
  b.rooms.push_back(test::make_box("1", 8, 6));
  b.rooms.push_back(test::make_box("2", 4, 6));
  b.rooms[1].frame = {{8.0, 0.0}, 0.0};
  b.rooms[0].corners = {{0, 0}, {8, 0}, {8, 6}, {0, 6}};
  b.rooms[0].edges = {{6.0, 5.0}};
  b.rooms[0].reflectors.push_back({{2.0, 0.5}, {3.0, 0.5}});
  test::add_door(b, 0, {8, 2}, 1, {0, 2});
  return b;
}

class EchoExplainerTest : public ::testing::Test {
 protected:
  /// What explains `range` on a sensor that looks along `direction_deg` from the belt of a wearer whose axis is at
  /// `at`.
  ExplainedEcho explain(Vec2 at, double direction_deg, double range, double sigma = 0.05) const {
    Estimate e;
    e.room = 0;
    e.pose = {at, degrees(direction_deg)};
    e.sigma_m = sigma;
    e.sigma_heading_rad = degrees(2.0);
    return EchoExplainer(building, belt).explain({1.0, 0, range}, e);
  }

  Building building = hall();
  BeltConfig belt{};
};

TEST_F(EchoExplainerTest, AWallIsWhereItsPerpendicularMeetsIt) {
  const ExplainedEcho echo = explain({3.0, 3.0}, 180.0, 2.85);
  EXPECT_EQ(echo.kind, ElementKind::wall);
  EXPECT_NEAR(echo.at.x, 0.0, 1e-9);
  EXPECT_NEAR(echo.at.y, 3.0, 1e-9);
  EXPECT_NEAR(echo.expected_m, 2.85, 1e-9);
  EXPECT_EQ(echo.room, 0);
}

TEST_F(EchoExplainerTest, CornersEdgesAndAllReflectiveElementsAreToldApart) {
  EXPECT_EQ(explain({2.0, 4.0}, 135.0, std::sqrt(8.0) - 0.15).kind, ElementKind::corner);
  EXPECT_EQ(explain({5.0, 4.0}, 45.0, std::sqrt(2.0) - 0.15).kind, ElementKind::edge);
  EXPECT_EQ(explain({2.5, 2.0}, -90.0, 1.35).kind, ElementKind::reflector);
}

TEST_F(EchoExplainerTest, ACornerHeardByWayOfAWallIsThatCorner) {
  const Vec2 at{5.0, 5.5};
  const Vec2 image = Vec2{0.0, 12.0} - at;  // of the corner (0, 0) behind the wall y = 6
  const ExplainedEcho mirrored = explain(at, to_degrees(std::atan2(image.y, image.x)), norm(image) - belt.radius_m);
  EXPECT_EQ(mirrored.kind, ElementKind::corner);
  EXPECT_EQ(mirrored.at, (Vec2{0.0, 0.0}));
}

TEST_F(EchoExplainerTest, WhatNothingMappedAgreesWithStaysUnexplained) {
  const ExplainedEcho echo = explain({3.0, 3.0}, 180.0, 1.0);
  EXPECT_EQ(echo.kind, ElementKind::none);
  EXPECT_EQ(echo.expected_m, Firing::kNoEcho);
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, 2.45).kind, ElementKind::none);
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, 2.45, 0.3).kind, ElementKind::wall) << "a position that is known less well";
}

TEST_F(EchoExplainerTest, OpenDoorsShowWhatIsBehindThemAndNothingBesideThem) {
  const ExplainedEcho beyond = explain({7.0, 2.0}, 0.0, 4.85);
  EXPECT_EQ(beyond.kind, ElementKind::wall);
  EXPECT_NEAR(beyond.at.x, 12.0, 1e-9);
  EXPECT_EQ(explain({7.0, 4.5}, 0.0, 4.85).kind, ElementKind::none) << "the wall is between";
}

TEST_F(EchoExplainerTest, WhatIsHiddenAnswersNot) {
  building.rooms[0].walls.push_back({{1.0, 2.0}, {1.0, 4.0}});  // a screen
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, 2.85).kind, ElementKind::none);
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, 1.85).kind, ElementKind::wall);
}

TEST_F(EchoExplainerTest, NothingIsExplainedWithoutAnEchoOrAPlace) {
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, Firing::kNoEcho).kind, ElementKind::none);
  EXPECT_EQ(explain({3.0, 3.0}, 180.0, std::numeric_limits<double>::quiet_NaN()).kind, ElementKind::none);
  EXPECT_EQ(explain({std::numeric_limits<double>::infinity(), 3.0}, 180.0, 2.85).kind, ElementKind::none);
  EXPECT_EQ(EchoExplainer(building, belt).explain({1.0, 0, 2.0}, Estimate{}).kind, ElementKind::none);
  EXPECT_EQ(EchoExplainer(building, belt).explain({1.0, 99, 2.0}, Estimate{}).kind, ElementKind::none);
}

}  // namespace
}  // namespace echoway
