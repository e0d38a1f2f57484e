#include "lib/base/geometry/convex_polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal::convex_polygon_test {

const Polygon kSquare = {{-20, -20}, {-20, 20}, {20, 20}, {20, -20}};

Polygon Reversed(Polygon polygon_m) {
  std::reverse(polygon_m.begin(), polygon_m.end());
  return polygon_m;
}

Eigen::Vector2d AnyPoint() {
  const auto coordinate = rc::gen::inRange(-10'000, 10'001);
  return {*coordinate / 100.0, *coordinate / 100.0};
}

TEST(ConvexPolygon, KnowsInWhichDirectionItsCornersGo) {
  EXPECT_TRUE(IsClockwise(kSquare));
  EXPECT_FALSE(IsClockwise(Reversed(kSquare)));
}

TEST(ConvexPolygon, IsOneOnlyWithoutDentsAndCrossings) {
  EXPECT_TRUE(IsConvex(kSquare));
  EXPECT_TRUE(IsConvex(Reversed(kSquare)));
  EXPECT_FALSE(IsConvex({{0, 0}, {10, 0}}));
  EXPECT_FALSE(IsConvex({{0, 0}, {10, 0}, {20, 0}}));
  EXPECT_FALSE(IsConvex({{0, 0}, {10, 10}, {20, 0}, {10, 3}}));
  EXPECT_FALSE(IsConvex({{0, 0}, {10, 10}, {10, 0}, {0, 10}}));
  // A star turns to one side at each corner, but twice round.
  EXPECT_FALSE(IsConvex({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}));
}

TEST(ConvexPolygon, HasNegativeDistancesInside) {
  EXPECT_DOUBLE_EQ(SignedDistance(kSquare, {0, 5}), -15);
  EXPECT_DOUBLE_EQ(SignedDistance(kSquare, {26, 0}), 6);
  EXPECT_DOUBLE_EQ(SignedDistance(Reversed(kSquare), {23, 24}), 5);
}

TEST(ConvexPolygon, HasItsCentreWhereItsAreaIsAndNotItsCorners) {
  EXPECT_TRUE(
      Centroid({{0, 0}, {1, 0}, {2, 0}, {6, 0}, {6, 6}, {0, 6}}).isApprox(Eigen::Vector2d(3, 3)));
  EXPECT_TRUE(Centroid({{0, 0}, {4, 0}}).isApprox(Eigen::Vector2d(2, 0)));
}

TEST(ConvexPolygon, GrowsWithArcsAboutItsCorners) {
  const Polygon grown_m = Grown(Reversed(kSquare), 5);
  EXPECT_EQ(grown_m.size(), 4U * 7);
  for (const Eigen::Vector2d& point_m : grown_m) {
    EXPECT_NEAR(SignedDistance(kSquare, point_m), 5, 1e-12);
  }
  EXPECT_NEAR(SignedDistance(grown_m, {0, 0}), -25, 1e-12);
  EXPECT_TRUE(IsConvex(grown_m));
}

TEST(ConvexPolygon, IsMetByRaysThatPointAtIt) {
  EXPECT_NEAR(RayDistance(kSquare, {50, 0}, DegToRad(270)).value(), 30, 1e-9);
  EXPECT_NEAR(RayDistance(kSquare, {0, 0}, 0).value(), 20, 1e-9);
  EXPECT_FALSE(RayDistance(kSquare, {50, 0}, DegToRad(90)).has_value());
  EXPECT_FALSE(RayDistance(kSquare, {50, 0}, 0).has_value());
}

RC_GTEST_PROP(ConvexPolygon, ContainsThePointWhereARayMeetsIt, ()) {
  const Eigen::Vector2d from_m = AnyPoint();
  const double heading_rad = DegToRad(*rc::gen::inRange(0, 360));
  const std::optional<double> distance_m = RayDistance(kSquare, from_m, heading_rad);
  RC_PRE(distance_m.has_value());
  const Eigen::Vector2d met_m = from_m + *distance_m * UnitVector(heading_rad);
  RC_ASSERT(std::abs(SignedDistance(kSquare, met_m)) < 1e-9);
  RC_ASSERT(*distance_m >= std::abs(SignedDistance(kSquare, from_m)) - 1e-9);
}

}  // namespace shoal::convex_polygon_test
