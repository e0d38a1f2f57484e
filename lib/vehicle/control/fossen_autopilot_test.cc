// Holds the vehicle `fossen` and the gains of that name to Fossen's own closed loop: depth by a PI
// over a pitch PID, heading by an integral sliding mode with a reference model of third order
// (Fossen 2021, eq. 16.479). The sliding mode is here and not in lib/vehicle/control, which has its
// PID alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/control/named_pilots.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "tests/golden/read_golden.h"

namespace shoal::fossen_autopilot_test {

constexpr double kStep_s = 0.02;
constexpr double kNoLimit_rad = 1e9;

struct FossenAutopilot {
  double z_ref_m = 0;
  double psi_ref_rad = 0;

  double z_d_m = 0;
  DepthPi depth = {};
  AnglePid pitch = {};
  double psi_d_rad = 0, r_d = 0, a_d = 0, psi_integral = 0;

  Remus100Actuators Update(const Vector6d& eta, const Vector6d& nu) {
    return {UpdateRudder(eta[5], nu[5]), UpdateSternPlane(eta[2], eta[4], nu[2], nu[4]), 1525};
  }

  double UpdateSternPlane(double z_m, double theta_rad, double w, double q) {
    const double keep = std::exp(-kStep_s * 0.02);
    z_d_m = keep * z_d_m + (1 - keep) * z_ref_m;
    AuvPilotParams gains = FossenRemusPilot();
    gains.depth.max_pitch_rad = gains.pitch.max_output_rad = kNoLimit_rad;  // As the original.
    const double theta_d_rad = depth.Update(gains.depth, z_m, z_d_m, kStep_s);
    return pitch.Update(gains.pitch, theta_rad, theta_d_rad,
                        q + kFossenHeaveGain / gains.pitch.kd * w, kStep_s);
  }

  double UpdateRudder(double psi_rad, double r) {
    constexpr double kLambda = 0.1;
    constexpr double kTime_s = 1, kGain = 0.25;
    const double error = WrapPi(psi_rad - psi_d_rad);
    const double rate_error = r - r_d;
    const double reference_dot = a_d - 2 * kLambda * rate_error - kLambda * kLambda * error;
    const double reference = r_d - 2 * kLambda * error - kLambda * kLambda * psi_integral;
    const double sigma = rate_error + 2 * kLambda * error + kLambda * kLambda * psi_integral;
    const double switching = std::clamp(sigma / 0.1, -1.0, 1.0);
    const double rudder =
        (kTime_s * reference_dot + reference - 0.5 * sigma - 0.05 * switching) / kGain;
    psi_integral += kStep_s * error;

    constexpr double kFrequency = 0.1, kDamping = 1;
    const double factor = 2 * kDamping + 1;
    const double jerk = std::pow(kFrequency, 3) * (psi_ref_rad - psi_d_rad) -
                        factor * kFrequency * kFrequency * r_d - factor * kFrequency * a_d;
    psi_d_rad += kStep_s * r_d;
    r_d += kStep_s * a_d;
    a_d += kStep_s * jerk;
    r_d = std::clamp(r_d, -DegToRad(5), DegToRad(5));
    return rudder;
  }
};

TEST(FossenRemus100, KeepsDepthAndHeadingInACurrentAsItsOriginal) {
  constexpr const char* kEta[] = {"x", "y", "z", "phi", "theta", "psi"};
  constexpr const char* kNu[] = {"u", "v", "w", "p", "q", "r"};
  const Remus100 auv = BuildRemus100(FossenRemus100());
  const double toward_rad = DegToRad(170);
  const Remus100Environment environment = {
      .current_mps = Eigen::Vector3d(0.5 * std::cos(toward_rad), 0.5 * std::sin(toward_rad), 0)};
  FossenAutopilot autopilot{.z_ref_m = 30, .psi_ref_rad = DegToRad(50)};
  Remus100State state;
  int step = 0;
  Remus100Actuators command;
  for (const GoldenRow& row : ReadGoldenCsv("munet/fossen_remus100_autopilot.csv")) {
    for (; step <= static_cast<int>(Number(row, "i")); ++step) {
      if (step > 0) state = Step(auv, state, command, environment, kStep_s);
      command = autopilot.Update(state.eta, state.nu);
    }
    const double tolerance = step <= 1500 ? 1e-8 : 1e-6;
    for (int i = 0; i < 6; ++i) {
      const double golden = Number(row, kEta[i]);
      const double difference = state.eta[i] - golden;
      ASSERT_NEAR(i < 3 ? difference : WrapPi(difference), 0,
                  tolerance * std::max(1.0, std::abs(golden)))
          << "step " << step << " " << kEta[i];
      ASSERT_NEAR(state.nu[i], Number(row, kNu[i]), tolerance) << "step " << step << " " << kNu[i];
    }
    ASSERT_NEAR(autopilot.z_d_m, Number(row, "z_d"), tolerance) << step;
    ASSERT_NEAR(autopilot.psi_d_rad, Number(row, "psi_d"), tolerance) << step;
  }
  EXPECT_GT(step, 9900);
}

TEST(FossensHeadingGains, AreItsSlidingModeWithinTheBoundaryLayer) {
  AnglePidGains gains = FossenRemusPilot().heading;
  gains.max_output_rad = kNoLimit_rad;
  int num_within = 0;
  for (const double psi_rad : {-0.15, -0.02, 0.0, 0.1, 0.2}) {
    for (const double r_radps : {-0.03, 0.0, 0.04}) {
      for (const double integral_rads : {-1.0, 0.0, 0.7}) {
        FossenAutopilot sliding;
        sliding.psi_integral = integral_rads;
        const double sigma = r_radps + 0.2 * psi_rad + 0.01 * integral_rads;
        if (std::abs(sigma) > 0.1) continue;
        ++num_within;
        AnglePid pid{.integral_rads = integral_rads};
        EXPECT_NEAR(pid.Update(gains, psi_rad, 0, r_radps, kStep_s),
                    sliding.UpdateRudder(psi_rad, r_radps), 1e-12)
            << psi_rad << " " << r_radps << " " << integral_rads;
      }
    }
  }
  EXPECT_GT(num_within, 40);
}

TEST(NamedPilots, AreTheThreeThatMissionFilesKnow) {
  EXPECT_EQ(RemusPilotByName("default")->heading, DefaultRemusPilot().heading);
  EXPECT_EQ(RemusPilotByName("munet")->heading, MunetRemusPilot().heading);
  EXPECT_EQ(RemusPilotByName("fossen")->pitch, FossenRemusPilot().pitch);
  EXPECT_FALSE(RemusPilotByName("Fossen"));
}

}  // namespace shoal::fossen_autopilot_test
