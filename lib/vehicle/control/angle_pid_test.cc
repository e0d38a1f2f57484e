#include "lib/vehicle/control/angle_pid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "tests/golden/read_golden.h"

namespace shoal::angle_pid_test {

constexpr double kTolerance = 1e-12;

TEST(AnglePid, MatchesMunetsHeadingLaw) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/ctrl_headingPID.csv")) {
    AnglePidGains gains = MunetRemusPilot().heading;
    gains.ki = Number(row, "Ki_psi");
    AnglePid pid{.integral_rads = Number(row, "psi_int")};
    const double delta_rad = pid.Update(gains, Number(row, "psi"), Number(row, "psi_d"),
                                        Number(row, "r"), Number(row, "h"));
    EXPECT_NEAR(delta_rad, Number(row, "delta_r"), kTolerance);
    EXPECT_NEAR(pid.integral_rads, Number(row, "n_psi_int"),
                kTolerance * (1 + std::abs(Number(row, "n_psi_int"))));
  }
}

TEST(AnglePid, MatchesMunetsPitchLaw) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/ctrl_pitchPID.csv")) {
    AnglePid pid{.integral_rads = Number(row, "theta_int")};
    const double delta_rad = pid.Update(MunetRemusPilot().pitch, Number(row, "theta"),
                                        Number(row, "theta_d"), Number(row, "q"), Number(row, "h"));
    EXPECT_NEAR(delta_rad, Number(row, "delta_s"), kTolerance);
    EXPECT_NEAR(pid.integral_rads, Number(row, "n_theta_int"),
                kTolerance * (1 + std::abs(Number(row, "n_theta_int"))));
  }
}

TEST(DepthPi, MatchesMunetsDepthCascade) {
  const AuvPilotParams munet = MunetRemusPilot();
  for (const GoldenRow& row : ReadGoldenCsv("munet/ctrl_depthPID.csv")) {
    DepthPi depth{.integral_ms = Number(row, "z_int")};
    AnglePid pitch{.integral_rads = Number(row, "theta_int")};
    const double theta_d_rad =
        depth.Update(munet.depth, Number(row, "z"), Number(row, "z_d"), Number(row, "h"));
    const double delta_rad = pitch.Update(munet.pitch, Number(row, "theta"), theta_d_rad,
                                          Number(row, "q"), Number(row, "h"));
    EXPECT_NEAR(theta_d_rad, Number(row, "n_theta_d"), kTolerance);
    EXPECT_NEAR(delta_rad, Number(row, "delta_s"), kTolerance);
    EXPECT_NEAR(depth.integral_ms, Number(row, "n_z_int"),
                kTolerance * (1 + std::abs(Number(row, "n_z_int"))));
    EXPECT_NEAR(pitch.integral_rads, Number(row, "n_theta_int"),
                kTolerance * (1 + std::abs(Number(row, "n_theta_int"))));
  }
}

TEST(AnglePid, TakesTheShorterWayRound) {
  const AnglePidGains gains = {.kp = -1, .max_output_rad = 1};
  AnglePid pid;
  EXPECT_NEAR(pid.Update(gains, 3.1, -3.1, 0, 0.1), 2 * kPi - 6.2, 1e-12);
  EXPECT_NEAR(pid.Update(gains, -3.1 + 20 * kPi, 3.1, 0, 0.1), 6.2 - 2 * kPi, 1e-12);
}

TEST(AnglePid, AsksForJustTheLimitOnceItHasBeenReached) {
  const AnglePidGains gains = {.kp = -1, .ki = -0.5, .max_output_rad = 0.2};
  AnglePid pid;
  EXPECT_EQ(pid.Update(gains, 1, 0, 0, 0.1), -0.2);
  EXPECT_NEAR(gains.kp * 1 + gains.ki * pid.integral_rads, -0.2, 1e-12);
  EXPECT_GT(pid.Update(gains, 0.9, 0, 0, 0.1), -0.2);  // Leaves the limit with the error.
}

RC_GTEST_PROP(AnglePid, StaysWithinItsLimitAndFiniteWhateverItIsGiven, ()) {
  const auto any = rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::element(1e308, -1e308));
  const auto finite = [&] {
    const double value = *any;
    return std::isfinite(value) ? value : 0;
  };
  const AuvPilotParams params = DefaultRemusPilot();
  AnglePid pid{.integral_rads = finite()};
  DepthPi depth{.integral_ms = finite()};
  for (int i = 0; i < 5; ++i) {
    const double delta_rad = pid.Update(params.pitch, finite(), finite(), finite(), 0.1);
    const double theta_d_rad = depth.Update(params.depth, finite(), finite(), 0.1);
    RC_ASSERT(std::abs(delta_rad) <= params.pitch.max_output_rad);
    RC_ASSERT(std::abs(theta_d_rad) <= params.depth.max_pitch_rad);
    RC_ASSERT(std::isfinite(pid.integral_rads));
    RC_ASSERT(std::isfinite(depth.integral_ms));
  }
}

}  // namespace shoal::angle_pid_test
