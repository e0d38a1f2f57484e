#include "lib/helm/behaviors/track_line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal::track_line_test {

const Leg kNorth = {.from_m = {0, 0}, .to_m = {0, 100}};

void ExpectPoint(const Eigen::Vector2d& position_m, const TrackLead& lead, double along_m) {
  const Eigen::Vector2d point_m = SteeringPoint(kNorth, position_m, lead);
  EXPECT_NEAR(point_m.x(), 0, 1e-12);
  EXPECT_NEAR(point_m.y(), along_m, 1e-12);
}

TEST(SteeringPoint, IsTheLeadAheadOfThePointBeside) {
  ExpectPoint({5, 30}, {.lead_m = 8}, 38);
  ExpectPoint({-5, 30}, {.lead_m = 8}, 38);
}

TEST(SteeringPoint, IsNeverBeyondTheEnd) {
  ExpectPoint({5, 95}, {.lead_m = 8}, 100);
  ExpectPoint({5, 130}, {.lead_m = 8}, 100);
}

TEST(SteeringPoint, CountsFromTheBeginningForAVesselBeforeTheLeg) {
  ExpectPoint({5, -30}, {.lead_m = 8}, 8);
}

TEST(SteeringPoint, LeadsUpToThreeTimesAsFarOnTheLine) {
  ExpectPoint({0, 30}, {.lead_m = 8, .lead_damper_m = 2}, 54);
  ExpectPoint({1, 30}, {.lead_m = 8, .lead_damper_m = 2}, 46);
  ExpectPoint({2, 30}, {.lead_m = 8, .lead_damper_m = 2}, 38);
}

TEST(SteeringPoint, IsTheEndWithoutALeadOrALeg) {
  ExpectPoint({5, 30}, {}, 100);
  const Leg none = {.from_m = {3, 4}, .to_m = {3, 4}};
  EXPECT_EQ(SteeringPoint(none, {0, 0}, {.lead_m = 8}), Eigen::Vector2d(3, 4));
}

TEST(SteeringPoint, ComesBackToTheLegAtNoMoreThanTheReturnAngle) {
  ExpectPoint({20, 30}, {.lead_m = 8, .return_deg = 45}, 50);
  ExpectPoint({-20, 30}, {.lead_m = 8, .return_deg = 45}, 50);
  ExpectPoint({5, 30}, {.lead_m = 8, .return_deg = 45}, 38);
  ExpectPoint({20, 30}, {.lead_m = 8, .return_deg = 90}, 38);
}

TEST(Diversion, LastsFromAContactUntilTheVesselIsBackAtItsLeg) {
  const Leg leg = {.from_m = {0, 0}, .to_m = {0, 100}};
  Diversion diversion;
  diversion.Look(false, leg, {20, 30}, 8, 15);
  EXPECT_FALSE(diversion.is_on());
  diversion.Look(true, leg, {0, 30}, 8, 15);
  diversion.Look(false, leg, {20, 40}, 8, 15);
  EXPECT_TRUE(diversion.is_on());
  // 8 m tan 15 degrees is 2.14 m: from there on the lead alone comes back at no more than 15.
  diversion.Look(false, leg, {2.2, 60}, 8, 15);
  EXPECT_TRUE(diversion.is_on());
  diversion.Look(false, leg, {2.1, 60}, 8, 15);
  EXPECT_FALSE(diversion.is_on());
  diversion.Look(false, leg, {20, 60}, 8, 15);
  EXPECT_FALSE(diversion.is_on());
}

TEST(Diversion, EndsWithoutAJumpOfTheCourse) {
  const Leg leg = {.from_m = {0, 0}, .to_m = {0, 500}};
  Diversion diversion;
  diversion.Look(true, leg, {0, 30}, 8, 15);
  double last_deg = 15;
  for (double off_m = 30; off_m >= 0; off_m -= 0.05) {
    const Eigen::Vector2d position_m = {off_m, 30};
    diversion.Look(false, leg, position_m, 8, 15);
    const Eigen::Vector2d to_m =
        SteeringPoint(leg, position_m, {.lead_m = 8, .return_deg = diversion.is_on() ? 15.0 : 90}) -
        position_m;
    const double course_deg = RadToDeg(std::atan2(-to_m.x(), to_m.y()));
    EXPECT_NEAR(course_deg, last_deg, 0.5) << off_m << " m off";
    last_deg = course_deg;
  }
  EXPECT_NEAR(last_deg, 0, 0.5);
}

}  // namespace shoal::track_line_test
