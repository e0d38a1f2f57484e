// Predictions against MuNet's numbers (tests/golden/munet). Rows in which MuNet is wrong are marked
// with the fault that explains them, by its number in the notes on MuNet.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/motion_prediction.h"
#include "tests/golden/read_golden.h"

namespace shoal::prediction_golden_test {

using Eigen::Vector3d;

Vector3d Vector(const GoldenRow& row, const std::string& prefix) {
  return {Number(row, prefix + "x"), Number(row, prefix + "y"), Number(row, prefix + "z")};
}

testing::AssertionResult Equal(const Vector3d& value, const Vector3d& golden) {
  if ((value - golden).norm() <= 1e-12 * std::max(1.0, golden.norm())) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << value.transpose() << " is not " << golden.transpose();
}

// MuNet's rpm to speed map of its Remus 100, and the map's slope.
double MunetSpeed(double rpm) {
  if (rpm <= 100) return .000611108 * rpm;
  return rpm <= 400 ? .00196552 * rpm - .135849 : .0016922 * rpm - .0273616;
}
double MunetSlope(double rpm) {
  if (rpm <= 100) return .000611108;
  return rpm <= 400 ? .00196552 : .0016922;
}

TEST(PredictNextGolden, IsThatOfMunetAtConstantSpeed) {
  int num_accelerated = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/predictNextEtaVel.csv")) {
    const Motion own{.position_m = Vector(row, "")};
    const Vector3d next_m = Vector(row, "next_");
    const double rate = Number(row, "n_rate");
    const Vector3d munet_mps = Vector(row, "next_v");
    if (rate == 0) {
      const Motion next =
          PredictAtPoint(own, next_m, {.speed_mps = MunetSpeed(Number(row, "n_setpt"))});
      EXPECT_TRUE(Equal(next.position_m, next_m));
      EXPECT_TRUE(Equal(next.velocity_mps, munet_mps));
      continue;
    }
    // MuNet takes the speed at `rate` rpm for an acceleration, gets NaN when slowing down, and
    // knows no greatest speed.
    ++num_accelerated;
    const double rpm = Number(row, "rpm_act");
    const SpeedPlan plan{.speed_mps = MunetSpeed(rpm), .acceleration_mps2 = MunetSlope(rpm) * rate};
    const Vector3d v_mps = PredictAtPoint(own, next_m, plan).velocity_mps;
    EXPECT_LE(v_mps.norm(), plan.max_speed_mps * (1 + 1e-12));
    EXPECT_GE(rate * (v_mps.norm() - plan.speed_mps), -1e-9);
    // With MuNet's acceleration and no greatest speed it is MuNet's velocity again.
    if (!munet_mps.allFinite()) continue;
    const SpeedPlan munet{
        .speed_mps = MunetSpeed(rpm), .acceleration_mps2 = MunetSpeed(rate), .max_speed_mps = 1e9};
    EXPECT_TRUE(Equal(PredictAtPoint(own, next_m, munet).velocity_mps, munet_mps));
  }
  EXPECT_GT(num_accelerated, 0);
}

TEST(PredictSwarmGolden, IsThatOfMunetUntilTheLeaderArrives) {
  int num_same = 0;
  int num_other = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/predictSwarmState.csv")) {
    const double h_s = Number(row, "h");
    // MuNet makes up for the delay of a message in the step after it.
    const auto elapsed_s = [&](const std::string& delay) {
      return Number(row, delay) > h_s ? Number(row, delay) : h_s;
    };
    const Motion member =
        PredictMember({.position_m = Vector(row, "m_"), .velocity_mps = Vector(row, "m_v")},
                      elapsed_s("m_delay"));
    EXPECT_TRUE(Equal(member.position_m, Vector(row, "nm_")));
    EXPECT_TRUE(Equal(member.velocity_mps, Vector(row, "nm_v")));

    const MotionReport report{
        .now = {.position_m = Vector(row, "t_"), .velocity_mps = Vector(row, "t_v")},
        .next = {.position_m = Vector(row, "t_next_"), .velocity_mps = Vector(row, "t_nextv")}};
    const PredictionLimits limits;
    const double t_s = elapsed_s("t_delay");
    const Motion leader = PredictLeader(report, t_s, limits);
    const Vector3d way_m = report.next.position_m - report.now.position_m;
    const Vector3d ahead = way_m.normalized();
    const double v_i_mps = report.now.velocity_mps.dot(ahead);
    const double v_f_mps = report.next.velocity_mps.dot(ahead);
    const double a_mps2 = (v_f_mps * v_f_mps - v_i_mps * v_i_mps) / (2 * way_m.norm());
    // MuNet's answer is wrong beyond the limit of acceleration, and where none leads to the point.
    const bool is_odd = way_m.norm() == 0 || std::abs(a_mps2) > limits.max_acceleration_mps2 ||
                        (v_i_mps <= 0 && a_mps2 <= 0) ||
                        v_i_mps * t_s + a_mps2 * t_s * t_s / 2 > way_m.norm();
    if (is_odd) {
      ++num_other;
      EXPECT_TRUE(leader.position_m.allFinite() && leader.velocity_mps.allFinite());
      continue;
    }
    ++num_same;
    EXPECT_TRUE(Equal(leader.position_m, Vector(row, "nt_")));
    EXPECT_TRUE(Equal(leader.velocity_mps, Vector(row, "nt_v")));
  }
  EXPECT_GT(num_same, 2 * num_other) << num_same << " " << num_other;
  EXPECT_GT(num_other, 0);
}

}  // namespace shoal::prediction_golden_test
