// Holds the published parameter sets to what their programs compute.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "tests/golden/read_golden.h"

namespace shoal::remus100_golden_test {

constexpr const char* kEta[] = {"x", "y", "z", "phi", "theta", "psi"};
constexpr const char* kNu[] = {"u", "v", "w", "p", "q", "r"};

/// Reads a state from columns `prefix`x, `prefix`y and so on.
Remus100State ReadState(const GoldenRow& row, const std::string& prefix = "") {
  Remus100State state;
  for (int i = 0; i < 6; ++i) {
    state.eta[i] = Number(row, prefix + kEta[i]);
    state.nu[i] = Number(row, prefix + kNu[i]);
  }
  state.actuators = {Number(row, prefix + "rud_act"), Number(row, prefix + "stern_act"),
                     Number(row, prefix + "rpm_act")};
  state.immobilized = row.contains("immobilized") && row.at("immobilized") == "1";
  return state;
}

Remus100Actuators ReadCommand(const GoldenRow& row) {
  return {Number(row, "rud_cmd"), Number(row, "stern_cmd"), Number(row, "rpm_cmd")};
}

Eigen::Vector3d Current(double speed_mps, double direction_rad) {
  return {speed_mps * std::cos(direction_rad), speed_mps * std::sin(direction_rad), 0};
}

void ExpectNear(double value, double golden, double tolerance, const std::string& what) {
  EXPECT_NEAR(value, golden, tolerance * std::max(1.0, std::abs(golden))) << what;
}

/// Compares with `tolerance` relative, and absolute for values below 1.
void ExpectState(const Remus100State& state, const Remus100State& golden, double tolerance,
                 const std::string& where) {
  for (int i = 0; i < 6; ++i) {
    ExpectNear(state.nu[i], golden.nu[i], tolerance, where + " " + kNu[i]);
    const double difference = state.eta[i] - golden.eta[i];
    EXPECT_NEAR(i < 3 ? difference : WrapPi(difference), 0,
                tolerance * std::max(1.0, std::abs(golden.eta[i])))
        << where << " " << kEta[i];
  }
  ExpectNear(state.actuators.rudder_rad, golden.actuators.rudder_rad, tolerance, where + " rudder");
  ExpectNear(state.actuators.stern_plane_rad, golden.actuators.stern_plane_rad, tolerance,
             where + " stern plane");
  ExpectNear(state.actuators.propeller_rpm, golden.actuators.propeller_rpm, tolerance,
             where + " propeller");
}

TEST(MunetRemus100, HasThePublishedConstants) {
  const nlohmann::json golden = ReadGoldenJson("munet/remus_params.json");
  const Remus100 auv = BuildRemus100(MunetRemus100());
  const auto expect = [&](double value, const char* name) {
    EXPECT_NEAR(value, golden.at(name).get<double>(),
                1e-13 * std::abs(golden.at(name).get<double>()))
        << name;
  };
  const auto expect_matrix = [&](const Matrix6d& matrix, const char* name) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        const double value = golden.at(name).at(static_cast<size_t>(i)).at(static_cast<size_t>(j));
        EXPECT_NEAR(matrix(i, j), value, 1e-13 * (1 + std::abs(value))) << name << i << j;
      }
    }
  };
  expect(auv.rigid_body_mass(0, 0), "mass");
  expect(auv.submerged.weight_n, "W");
  expect(auv.submerged.buoyancy_n, "B");
  expect(auv.wing.area_m2, "S");
  expect(auv.wing.parasitic_drag, "CD_0");
  expect(auv.cross_flow.drag_coefficient, "Cd_2D_Hoerner");
  expect(auv.roll_frequency_radps, "w_roll");
  expect(auv.pitch_frequency_radps, "w_pitch");
  expect(auv.params.max_fin_rad, "deltaMax_r");
  expect_matrix(auv.rigid_body_mass, "MRB");
  expect_matrix(auv.added_mass, "MA");
  expect_matrix(auv.mass, "M");
  expect_matrix(auv.mass_inverse, "Minv");
}

TEST(MunetRemus100, MatchesItsOriginalInOneStep) {
  const Remus100 auv = BuildRemus100(MunetRemus100());
  for (const GoldenRow& row : ReadGoldenCsv("munet/remus_onestep.csv")) {
    const Remus100Environment environment = {
        .current_mps = Current(Number(row, "Vc"), Number(row, "betac")),
        .floor_z_m = Number(row, "z_floor")};
    const Remus100State next =
        Step(auv, ReadState(row), ReadCommand(row), environment, Number(row, "h"));
    // The table's own state has `immobilized` as it is after the step.
    if (row.at("immobilized") == "1") continue;
    ExpectState(next, ReadState(row, "n_"), 1e-12, "row " + row.at("id"));
    ExpectNear(next.velocity_mps.x(), Number(row, "vx"), 1e-12, "vx");
    ExpectNear(next.velocity_mps.y(), Number(row, "vy"), 1e-12, "vy");
    ExpectNear(next.velocity_mps.z(), Number(row, "vz"), 1e-12, "vz");
  }
}

TEST(MunetRemus100, IsImmobilizedBelowTheFloorAsItsOriginal) {
  const Remus100 auv = BuildRemus100(MunetRemus100());
  int num_grounded = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/remus_onestep.csv")) {
    Remus100State start = ReadState(row);
    start.immobilized = false;
    const Remus100State next =
        Step(auv, start, ReadCommand(row), {.floor_z_m = Number(row, "z_floor")}, Number(row, "h"));
    EXPECT_EQ(next.immobilized, row.at("immobilized") == "1") << row.at("id");
    if (!next.immobilized) continue;
    ++num_grounded;
    ExpectState(next, ReadState(row, "n_"), 0, "row " + row.at("id"));
  }
  EXPECT_EQ(num_grounded, 10);
}

/// Sails from the first row on under the commands of the rows; each row is compared.
void ExpectOpenLoop(const std::string& file, const Remus100Params& params,
                    const Eigen::Vector3d& current_mps, double tolerance) {
  const Remus100 auv = BuildRemus100(params);
  const std::vector<GoldenRow> rows = ReadGoldenCsv(file);
  Remus100State state = ReadState(rows.front());
  int step = 0;
  for (size_t i = 0; i + 1 < rows.size(); ++i) {
    const Remus100Actuators command = ReadCommand(rows[i]);
    for (; step < static_cast<int>(Number(rows[i + 1], "i")); ++step) {
      state = Step(auv, state, command, {.current_mps = current_mps}, 0.02);
    }
    ExpectState(state, ReadState(rows[i + 1]), tolerance, file + " step " + std::to_string(step));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(MunetRemus100, SailsAsItsOriginalInOpenLoop) {
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  for (const char* name : {"accel", "fullspeed_coast", "rudder_step", "stern_step"}) {
    ExpectOpenLoop(std::string("munet/remus_ol_") + name + ".csv", MunetRemus100(), still, 1e-8);
  }
  ExpectOpenLoop("munet/remus_ol_drift_nothrust.csv", MunetRemus100(), Current(0.4, -1), 1e-8);
  ExpectOpenLoop("munet/remus_ol_current_turn.csv", MunetRemus100(), Current(0.5, 2), 1e-8);
}

TEST(FossenRemus100, MatchesItsOriginalInOneStep) {
  const Remus100 auv = BuildRemus100(FossenRemus100());
  for (const GoldenRow& row : ReadGoldenCsv("munet/fossen_remus100_onestep.csv")) {
    const Remus100State next =
        Step(auv, ReadState(row), ReadCommand(row),
             {.current_mps = Current(Number(row, "Vc"), Number(row, "betac"))}, Number(row, "h"));
    ExpectState(next, ReadState(row, "n_"), 1e-12, "row " + row.at("id"));
  }
}

// The stern plane goes back after 50 s, the rudder after 100 s.
TEST(FossenRemus100, AnswersStepInputsAsItsOriginal) {
  const Remus100 auv = BuildRemus100(FossenRemus100());
  Remus100State state;
  int step = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/fossen_remus100_stepinput.csv")) {
    for (; step < static_cast<int>(Number(row, "i")); ++step) {
      const Remus100Actuators command = {.rudder_rad = step > 5000 ? 0 : DegToRad(5),
                                         .stern_plane_rad = step > 2500 ? 0 : DegToRad(-5),
                                         .propeller_rpm = 1525};
      state = Step(auv, state, command, {}, 0.02);
    }
    ExpectState(state, ReadState(row), step <= 1500 ? 1e-8 : 1e-6, "step " + std::to_string(step));
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(step, 5900);
}

}  // namespace shoal::remus100_golden_test
