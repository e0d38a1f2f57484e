#include "lib/helm/behaviors/loiter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::loiter_test {

const std::vector<Eigen::Vector2d> kSquare = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};

LoiterOptions Square() { return {.polygon = kSquare, .speed = 1}; }

/// Lets the vessel go where the loiter steers, 1 m a call.
void Sail(TestVessel& vessel, LoiterBehavior& loiter, int metres) {
  for (int i = 0; i < metres; ++i) {
    const BehaviorAnswer answer = vessel.Run(loiter);
    const Eigen::Vector2d way_m = *answer.view.steers_for_m - vessel.own.motion.position_m;
    vessel.own.motion.heading_deg = Wrap360(RadToDeg(HeadingOf(way_m)));
    vessel.own.motion.position_m += way_m.normalized();
  }
}

TEST(Loiter, MeetsThePolygonAtTheVertexThatItComesToTangentially) {
  TestVessel vessel;
  LoiterBehavior clockwise(Square());
  EXPECT_EQ(vessel.RunAt(clockwise, {0, -200}).view.steers_for_m, Eigen::Vector2d(-50, -50));
  LoiterOptions options = Square();
  options.clockwise = "false";
  LoiterBehavior counter(options);
  EXPECT_EQ(vessel.Run(counter).view.steers_for_m, Eigen::Vector2d(50, -50));
}

TEST(Loiter, GoesRoundInItsDirection) {
  for (const bool clockwise : {true, false}) {
    TestVessel vessel;
    vessel.own.motion.position_m = {0, -200};
    LoiterOptions options = Square();
    options.clockwise = clockwise ? "true" : "false";
    LoiterBehavior loiter(options);
    Sail(vessel, loiter, 300);
    const Eigen::Vector2d position_m = vessel.own.motion.position_m;
    EXPECT_LT(SignedDistance(kSquare, position_m), 3);
    const double bearing_rad = HeadingOf(position_m);
    Sail(vessel, loiter, 30);
    const double moved_rad = WrapPi(HeadingOf(vessel.own.motion.position_m) - bearing_rad);
    EXPECT_EQ(moved_rad > 0, clockwise);
  }
}

TEST(Loiter, ChoosesTheDirectionThatItsHeadingIsBestFor) {
  LoiterOptions options = Square();
  options.clockwise = "best";
  for (const double heading_deg : {340, 20}) {
    TestVessel vessel;
    vessel.own.motion = {.position_m = {0, -200}, .heading_deg = heading_deg};
    LoiterBehavior loiter(options);
    // Off to port: the centre is to starboard, clockwise.
    EXPECT_EQ(vessel.Run(loiter).view.steers_for_m,
              heading_deg > 180 ? Eigen::Vector2d(-50, -50) : Eigen::Vector2d(50, -50));
  }
}

TEST(Loiter, PostsWhetherItAcquiresIsStableOrRecovers) {
  TestVessel vessel;
  LoiterBehavior loiter(Square());
  const auto mode_at = [&](const Eigen::Vector2d& position_m) {
    return PostOf(vessel.RunAt(loiter, position_m), "LOITER_MODE");
  };
  EXPECT_EQ(mode_at({0, -200}), VariableValue("acquiring_external"));
  EXPECT_EQ(mode_at({0, 0}), VariableValue("acquiring_internal"));
  EXPECT_EQ(mode_at({0, -55}), VariableValue("stable"));
  EXPECT_EQ(mode_at({0, -70}), VariableValue("recovering_external"));
  EXPECT_EQ(mode_at({0, -30}), VariableValue("recovering_internal"));
}

TEST(Loiter, PostsDistanceAndTimeToThePolygon) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 0.5;
  LoiterBehavior loiter(Square());
  BehaviorAnswer answer = vessel.RunAt(loiter, {0, -70});
  EXPECT_EQ(PostOf(answer, "LOITER_DIST_TO_POLY"), VariableValue(20.0));
  EXPECT_EQ(PostOf(answer, "LOITER_ETA_TO_POLY"), VariableValue(40.0));
  // The original divides by the heading; a resting vessel never comes.
  vessel.own.motion = {.position_m = {0, -70}, .heading_deg = 90};
  EXPECT_EQ(PostOf(vessel.Run(loiter), "LOITER_ETA_TO_POLY"), VariableValue(-1.0));
}

TEST(Loiter, MovesItsCentreToWhereItBeginsWithCenterActivate) {
  TestVessel vessel;
  LoiterOptions options = Square();
  options.center_activate = true;
  LoiterBehavior loiter(options);
  const BehaviorAnswer answer = vessel.RunAt(loiter, {300, 20});
  EXPECT_TRUE(Centroid(answer.view.points_m).isApprox(Eigen::Vector2d(300, 20)));
  (void)loiter.Idle(vessel.Inputs());
  EXPECT_TRUE(
      Centroid(vessel.RunAt(loiter, {0, 100}).view.points_m).isApprox(Eigen::Vector2d(0, 100)));
}

TEST(Loiter, EndsAfterTheAngleOfASlingshot) {
  TestVessel vessel;
  vessel.own.motion.position_m = {-52, -52};
  LoiterOptions options = Square();
  options.slingshot = 180;
  LoiterBehavior loiter(options);
  const auto completes_at = [&](double bearing_deg) {
    return vessel.RunAt(loiter, Eigen::Vector2d(52 * UnitVector(DegToRad(bearing_deg)))).completes;
  };
  for (const double bearing_deg : {225, 270, 315, 0, 40}) EXPECT_FALSE(completes_at(bearing_deg));
  EXPECT_TRUE(completes_at(50));
}

TEST(Loiter, WidensByItsSpiralFactorEachRound) {
  TestVessel vessel;
  vessel.own.motion.position_m = {-50, -55};
  LoiterOptions options = Square();
  options.spiral_factor = 10;
  LoiterBehavior loiter(options);
  double radius_m = 0;
  for (int i = 0; i < 440; ++i) {
    Sail(vessel, loiter, 1);
    radius_m = vessel.Run(loiter).view.points_m.front().norm();
  }
  EXPECT_NEAR(radius_m, 50 * std::sqrt(2) + 10, 1e-9);
}

TEST(Loiter, AcquiresAnotherPolygonAnewAndKeepsItsPlaceWhereOnlyTheSpeedChanges) {
  TestVessel vessel;
  vessel.own.motion.position_m = {-50, -55};
  LoiterBehavior loiter(Square());
  Sail(vessel, loiter, 60);
  const BehaviorAnswer before = vessel.Run(loiter);
  LoiterOptions faster = Square();
  faster.speed = 2;
  loiter.Reconfigure(faster);
  const BehaviorAnswer after = vessel.Run(loiter);
  EXPECT_EQ(after.view.steers_for_m, before.view.steers_for_m);
  EXPECT_DOUBLE_EQ(vessel.Best(after).speed_mps, 2);
  for (Eigen::Vector2d& corner_m : faster.polygon) corner_m.x() += 500;
  loiter.Reconfigure(faster);
  EXPECT_EQ(vessel.Run(loiter).state, "acquiring_external");
}

}  // namespace shoal::loiter_test
