#include "lib/helm/behaviors/track_line.h"

#include <gtest/gtest.h>

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
  diversion.Look(false, leg, {20, 30}, 8);
  EXPECT_FALSE(diversion.is_on());
  diversion.Look(true, leg, {0, 30}, 8);
  diversion.Look(false, leg, {20, 40}, 8);
  EXPECT_TRUE(diversion.is_on());
  diversion.Look(false, leg, {7.9, 60}, 8);
  EXPECT_FALSE(diversion.is_on());
  diversion.Look(false, leg, {20, 60}, 8);
  EXPECT_FALSE(diversion.is_on());
}

}  // namespace shoal::track_line_test
