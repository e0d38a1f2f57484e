#include "lib/vehicle/guidance/motion_prediction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::motion_prediction_test {

using Eigen::Vector3d;

const Motion kEastbound{.position_m = {0, 0, 10}, .velocity_mps = {2, 0, 0}};

TEST(PredictAtPoint, KeepsTheSpeedWithoutAcceleration) {
  const Motion next = PredictAtPoint(kEastbound, {0, 100, 10}, {.speed_mps = 2});
  EXPECT_EQ(next.position_m, Vector3d(0, 100, 10));
  EXPECT_EQ(next.velocity_mps, Vector3d(0, 2, 0));
}

TEST(PredictAtPoint, SpeedsUpToTheGreatestSpeedAndSlowsDownToNone) {
  const Vector3d point_m(10, 0, 10);
  const auto speed = [&](double acceleration_mps2) {
    const SpeedPlan plan{.speed_mps = 1, .acceleration_mps2 = acceleration_mps2};
    return PredictAtPoint(kEastbound, point_m, plan).velocity_mps.x();
  };
  EXPECT_NEAR(speed(0.15), 2, 1e-12);
  EXPECT_EQ(speed(10), 2.5);
  EXPECT_EQ(speed(-10), 0);
}

TEST(PredictAtPoint, KeepsItsDirectionAtThePointItself) {
  const SpeedPlan plan{.speed_mps = 1.5};
  EXPECT_EQ(PredictAtPoint(kEastbound, kEastbound.position_m, plan).velocity_mps,
            Vector3d(1.5, 0, 0));
  EXPECT_EQ(PredictAtPoint({}, {0, 0, 0}, plan).velocity_mps, Vector3d::Zero());
}

MotionReport ReportTo(const Vector3d& next_m, const Vector3d& next_mps) {
  return {.now = kEastbound, .next = {.position_m = next_m, .velocity_mps = next_mps}};
}

TEST(PredictLeader, AcceleratesConstantlyOnTheWayToTheNextWaypoint) {
  const MotionReport report = ReportTo({75, 0, 10}, {1, 0, 0});  // a = -0.02
  const Motion after = PredictLeader(report, 20, {});
  EXPECT_NEAR(after.velocity_mps.x(), 2 - 0.02 * 20, 1e-12);
  EXPECT_NEAR(after.position_m.x(), 2 * 20 - 0.01 * 400, 1e-12);
}

TEST(PredictLeader, KeepsTheVelocityOfTheNextLegOnceItHasArrived) {
  const MotionReport report = ReportTo({20, 0, 10}, {0, 2, 0.1});  // Stops along x: 20 s.
  const Motion after = PredictLeader(report, 50, {});
  EXPECT_EQ(after.velocity_mps, Vector3d(0, 2, 0.1));
  EXPECT_NEAR((after.position_m - Vector3d(20, 60, 13)).norm(), 0, 1e-9);
}

TEST(PredictLeader, DoesNotJumpWhenItIsCloseToTheWaypoint) {
  const MotionReport report = ReportTo({1e-3, 0, 10}, {0, 0, 0});
  const Motion after = PredictLeader(report, 1e-4, {});
  EXPECT_NEAR(after.velocity_mps.x(), 2, 1e-3);
  EXPECT_EQ(PredictLeader(ReportTo({0, 0, 10}, {0, 1, 0}), 3, {}).position_m, Vector3d(0, 3, 10));
}

TEST(PredictLeader, KeepsItsSpeedWhereNoAccelerationLeadsToThePoint) {
  const MotionReport report = ReportTo({-100, 0, 10}, {-1, 0, 0});
  const Motion after = PredictLeader(report, 100, {});
  EXPECT_EQ(after.velocity_mps, kEastbound.velocity_mps);
  EXPECT_NEAR(after.position_m.x(), 200, 1e-9);
}

TEST(PredictMember, KeepsItsVelocity) {
  const Motion after = PredictMember(kEastbound, 3);
  EXPECT_EQ(after.position_m, Vector3d(6, 0, 10));
  EXPECT_EQ(after.velocity_mps, kEastbound.velocity_mps);
}

TEST(PredictMember, RefusesWhatIsNoNumber) {
  EXPECT_DEATH((void)PredictMember(kEastbound, std::numeric_limits<double>::infinity()),
               "inputs of guidance are finite");
}

// A leader that accelerates as it reported is where it is predicted to be.
RC_GTEST_PROP(PredictLeader, AgreesWithWhatTheLeaderPredictsOfItself, ()) {
  const Vector3d from_m = VectorWithin(300);
  const Vector3d to_m = VectorWithin(300);
  const double speed_mps = DrawBetween(0.5, 2);
  const double v_f_mps = DrawBetween(0.1, 2);
  const double distance_m = (to_m - from_m).norm();
  RC_PRE(distance_m > 5);  // Nearer than that the acceleration is beyond its limit.
  const double a_mps2 = (v_f_mps * v_f_mps - speed_mps * speed_mps) / (2 * distance_m);
  const Motion own{.position_m = from_m, .velocity_mps = speed_mps * (to_m - from_m) / distance_m};
  const SpeedPlan plan{.speed_mps = speed_mps, .acceleration_mps2 = a_mps2, .max_speed_mps = 100};
  const MotionReport report{.now = own, .next = PredictAtPoint(own, to_m, plan)};
  const double arrival_s = 2 * distance_m / (speed_mps + v_f_mps);
  const Motion there = PredictLeader(report, arrival_s * (1 - 1e-9), {});
  RC_ASSERT((there.position_m - to_m).norm() < 1e-4);
  RC_ASSERT((there.velocity_mps - report.next.velocity_mps).norm() < 1e-4);
}

RC_GTEST_PROP(PredictLeader, TurnsWithTheWorld, ()) {
  const Eigen::Matrix3d turn = AboutZ(DrawBetween(-3, 3));
  const MotionReport report{
      .now = {.position_m = VectorWithin(100), .velocity_mps = VectorWithin(2)},
      .next = {.position_m = VectorWithin(100), .velocity_mps = VectorWithin(2)}};
  const auto turned = [&](const Motion& motion) {
    return Motion{.position_m = turn * motion.position_m,
                  .velocity_mps = turn * motion.velocity_mps};
  };
  const double t_s = DrawBetween(0, 20);
  const Motion after = turned(PredictLeader(report, t_s, {}));
  const Motion again =
      PredictLeader({.now = turned(report.now), .next = turned(report.next)}, t_s, {});
  RC_ASSERT((after.position_m - again.position_m).norm() < 1e-6);
}

RC_GTEST_PROP(Predictions, AreFiniteForAnyFiniteReport, ()) {
  const auto any = [] {
    return Motion{.position_m = AnyFiniteVector(), .velocity_mps = AnyFiniteVector()};
  };
  const MotionReport report{.now = any(), .next = any()};
  const double t_s = std::abs(AnyFinite());
  const SpeedPlan plan{.speed_mps = AnyFinite(), .acceleration_mps2 = AnyFinite()};
  for (const Motion& motion : {PredictLeader(report, t_s, {}), PredictMember(report.now, t_s),
                               PredictAtPoint(report.now, report.next.position_m, plan)}) {
    RC_ASSERT(motion.position_m.allFinite());
    RC_ASSERT(motion.velocity_mps.allFinite());
  }
  RC_ASSERT(PredictAtPoint(report.now, report.next.position_m, plan).velocity_mps.norm() <=
            plan.max_speed_mps * (1 + 1e-12));
}

}  // namespace shoal::motion_prediction_test
