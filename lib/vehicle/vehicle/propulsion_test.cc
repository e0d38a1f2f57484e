#include "lib/vehicle/vehicle/propulsion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/golden/read_golden.h"

namespace shoal::propulsion_test {

constexpr double kRho = 1026;

TEST(Propeller, PushesWithTheCoefficientsOfItsAdvanceRatio) {
  const Propeller propeller;
  const double rps = 20;
  const double scale = kRho * std::pow(0.14, 4) * rps * rps;
  EXPECT_NEAR(ForceOf(propeller, kRho, 60 * rps, 0).thrust_n, 0.4566 * scale, 1e-9);
  const double speed_mps = 0.6632 * rps * 0.14 / 0.944;  // At the highest advance ratio.
  EXPECT_NEAR(ForceOf(propeller, kRho, 60 * rps, speed_mps).thrust_n, 0.1798 * scale, 1e-9);
  EXPECT_NEAR(ForceOf(propeller, kRho, 60 * rps, speed_mps).torque_nm, 0.0312 * scale * 0.14, 1e-9);
}

TEST(Propeller, IsContinuousAtRestAndInStillWater) {
  const Propeller propeller;
  for (const double speed_mps : {-1.0, 0.0, 2.0}) {
    const double ahead_n = ForceOf(propeller, kRho, 1e-6, speed_mps).thrust_n;
    const double astern_n = ForceOf(propeller, kRho, -1e-6, speed_mps).thrust_n;
    EXPECT_NEAR(ahead_n, astern_n, 1e-6);
  }
  EXPECT_NEAR(ForceOf(propeller, kRho, 900, -1e-9).thrust_n,
              ForceOf(propeller, kRho, 900, 1e-9).thrust_n, 1e-6);
}

TEST(SteadySpeed, IsThatOfTheBookForTheTopSpeed) {
  EXPECT_NEAR(SteadySpeed(BuildRemus100({}), 1525), 2.5, 0.06);
  EXPECT_EQ(SteadySpeed(BuildRemus100({}), 0), 0);
}

RC_GTEST_PROP(SteadySpeed, IsTheInverseOfRpmForSpeedInEverySet, ()) {
  const auto params = *rc::gen::element(Remus100Params{}, MunetRemus100(), FossenRemus100());
  const Remus100 auv = BuildRemus100(params);
  const double rpm = *rc::gen::inRange(-1525, 1526);
  RC_ASSERT(std::abs(RpmForSpeed(auv, SteadySpeed(auv, rpm)) - rpm) < 1e-6);
}

TEST(SpeedSlopes, AreByHowMuchTheMapsGrow) {
  const Remus100 auv = BuildRemus100({});
  for (const double rpm : {50.0, 250.0, 900.0, 1400.0}) {
    const double munet = (MunetSpeedFromRpm(rpm + 10) - MunetSpeedFromRpm(rpm - 10)) / 20;
    EXPECT_NEAR(MunetSpeedSlope(rpm), munet, 1e-12) << rpm;
    const double steady = (SteadySpeed(auv, rpm + 10) - SteadySpeed(auv, rpm - 10)) / 20;
    EXPECT_NEAR(SteadySpeedSlope(auv, rpm), steady, 0.02 * steady) << rpm;
  }
  EXPECT_GT(SteadySpeedSlope(auv, 1e300), 0.0015) << "that at full revolutions";
  EXPECT_GT(SteadySpeedSlope(auv, -1e300), 0);
}

TEST(SteadySpeed, GrowsWithTheRevolutionsAndStaysWithinThePropeller) {
  const Remus100 auv = BuildRemus100({});
  for (int rpm = -1500; rpm < 1500; rpm += 50) {
    EXPECT_LT(SteadySpeed(auv, rpm), SteadySpeed(auv, rpm + 50)) << rpm;
  }
  EXPECT_EQ(SteadySpeed(auv, 1e300), SteadySpeed(auv, 1525));
}

TEST(RpmForSpeed, IsFiniteForAnyFiniteSpeed) {
  for (const double speed_mps : {-1e308, -3.0, 0.0, 1e-300, 1e308}) {
    EXPECT_TRUE(std::isfinite(RpmForSpeed(BuildRemus100({}), speed_mps))) << speed_mps;
    EXPECT_TRUE(std::isfinite(MunetRpmFromSpeed(speed_mps))) << speed_mps;
    EXPECT_TRUE(std::isfinite(MunetSpeedFromRpm(speed_mps))) << speed_mps;
  }
}

TEST(MunetSpeedMaps, MatchTheTable) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/remus_rpm_speed_transfer.csv")) {
    const double in = Number(row, "in");
    const double out = row.at("func") == "N2U" ? MunetSpeedFromRpm(in) : MunetRpmFromSpeed(in);
    EXPECT_NEAR(out, Number(row, "out"), 1e-12 * std::abs(Number(row, "out"))) << in;
  }
}

// muNet fitted its lines to its own model; where it goes steadily they are within 1.5 per cent.
TEST(MunetSpeedMaps, AgreeWithTheDragBalanceAtCruisingSpeeds) {
  const Remus100 auv = BuildRemus100(MunetRemus100());
  for (const double rpm : {600.0, 900.0, 1200.0, 1500.0}) {
    EXPECT_NEAR(MunetSpeedFromRpm(rpm) / SteadySpeed(auv, rpm), 1, 0.015) << rpm;
  }
}

}  // namespace shoal::propulsion_test
