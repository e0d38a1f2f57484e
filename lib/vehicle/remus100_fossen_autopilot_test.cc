// Holds the set `fossen` to Fossen's own closed loop: depth by a PI over a pitch PID, heading by an
// integral sliding mode with a reference model of third order (Fossen 2021, eq. 16.479). The
// autopilot is here and not in lib/control, as nothing else uses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/geometry/angles.h"
#include "lib/vehicle/remus100.h"
#include "tests/golden/read_golden.h"

namespace shoal::remus100_fossen_autopilot_test {

constexpr double kStep_s = 0.02;

struct FossenAutopilot {
  double z_ref_m = 0;
  double psi_ref_rad = 0;

  double z_d_m = 0, z_integral = 0, theta_integral = 0;
  double psi_d_rad = 0, r_d = 0, a_d = 0, psi_integral = 0;

  Remus100Actuators Update(const Vector6d& eta, const Vector6d& nu) {
    return {UpdateRudder(eta[5], nu[5]), UpdateSternPlane(eta[2], eta[4], nu[2], nu[4]), 1525};
  }

  double UpdateSternPlane(double z_m, double theta_rad, double w, double q) {
    const double keep = std::exp(-kStep_s * 0.02);
    z_d_m = keep * z_d_m + (1 - keep) * z_ref_m;
    const double theta_d = 0.1 * ((z_m - z_d_m) + z_integral / 100);
    const double error = WrapPi(theta_rad - theta_d);
    const double plane = 5 * error + 2 * q + 0.3 * theta_integral + 5 * w;
    z_integral += kStep_s * (z_m - z_d_m);
    theta_integral += kStep_s * error;
    return plane;
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

}  // namespace shoal::remus100_fossen_autopilot_test
