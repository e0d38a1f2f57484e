#include "lib/vehicle/guidance/dubins.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal::dubins_test {

double LengthOf(const TurnPose& from, const TurnPose& to, double radius_m) {
  return ShortestWay(from, to, radius_m).Length_m();
}

TEST(ShortestWay, IsALineWhereTheGoalLiesAhead) {
  EXPECT_NEAR(LengthOf({}, {{0, 40}, 0}, 10), 40, 1e-9);
}

TEST(ShortestWay, IsHalfACircleAndALineFromLaneToLane) {
  EXPECT_NEAR(LengthOf({}, {{20, 0}, kPi}, 10), kPi * 10, 1e-9);
  EXPECT_NEAR(LengthOf({}, {{50, 0}, kPi}, 10), kPi * 10 + 30, 1e-9);
  EXPECT_NEAR(LengthOf({}, {{-50, 0}, kPi}, 10), kPi * 10 + 30, 1e-9);
}

TEST(ShortestWay, IsABulbWhereLanesAreNearerThanTwoRadii) {
  // It swings out by b on either side of three quarters of a circle: cos b = (2 r + d) / (4 r).
  for (const double spacing_m : {2.0, 10.0, 19.0}) {
    const double swing_rad = std::acos((20 + spacing_m) / 40);
    EXPECT_NEAR(LengthOf({}, {{spacing_m, 0}, kPi}, 10), 10 * (kPi + 4 * swing_rad), 1e-9);
  }
}

RC_GTEST_PROP(ShortestWay, EndsAtTheGoalAndTurnsNoTighterThanItsRadius, ()) {
  const auto degrees = rc::gen::inRange(0, 360);
  const auto metres = rc::gen::inRange(-100, 101);
  const TurnPose from = {Eigen::Vector2d(*metres, *metres), DegToRad(*degrees)};
  const TurnPose to = {Eigen::Vector2d(*metres, *metres), DegToRad(*degrees)};
  const double radius_m = *rc::gen::inRange(1, 40);
  const DubinsWay way = ShortestWay(from, to, radius_m);
  double heading_rad = from.heading_rad;
  for (const DubinsPart& part : way.parts) {
    RC_ASSERT(part.length_m >= 0);
    heading_rad += part.turn * part.length_m / radius_m;
  }
  RC_ASSERT(std::abs(WrapPi(heading_rad - to.heading_rad)) < 1e-6);
  const std::vector<Eigen::Vector2d> points_m = PointsAlong(way);
  const Eigen::Vector2d end_m = points_m.empty() ? from.position_m : points_m.back();
  RC_ASSERT((end_m - to.position_m).norm() < 1e-6);
  RC_ASSERT(way.Length_m() >= (to.position_m - from.position_m).norm() - 1e-9);
  // Back along the same way with opposite headings is as long.
  const TurnPose back_from = {to.position_m, to.heading_rad + kPi};
  const TurnPose back_to = {from.position_m, from.heading_rad + kPi};
  RC_ASSERT(std::abs(LengthOf(back_from, back_to, radius_m) - way.Length_m()) < 1e-6);
}

}  // namespace shoal::dubins_test
