// Autopilot and vehicle in one closed loop.
#include "lib/vehicle/control/auv_pilot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "tests/golden/read_golden.h"

namespace shoal::auv_pilot_test {

constexpr double kStep_s = 0.02;

AuvMotion MotionOf(const Remus100State& state) {
  return {.z_m = state.eta[2],
          .theta_rad = state.eta[4],
          .psi_rad = state.eta[5],
          .q_radps = state.nu[4],
          .r_radps = state.nu[5],
          .speed_mps = state.nu.head<3>().norm()};
}

/// muNet's path following: ALOS whose crab angle adapts everywhere, waypoints passed along the
/// track, as soon as less than 10 m of a leg are left.
struct MunetPath {
  std::vector<Eigen::Vector3d> waypoints_m;
  size_t leg = 0;
  double crab_rad = 0;
  double psi_ref_rad = 0;
  double z_ref_m = 0;

  void Update(const Remus100State& state) {
    const Eigen::Vector3d from_m = waypoints_m[leg];
    const Eigen::Vector3d to_m = waypoints_m[leg + 1];
    const Eigen::Vector2d way_m = (to_m - from_m).head<2>();
    const double path_rad = std::atan2(way_m.y(), way_m.x());
    const Eigen::Vector2d done_m = (state.eta.head<3>() - from_m).head<2>();
    const double along_m = done_m.x() * std::cos(path_rad) + done_m.y() * std::sin(path_rad);
    const double cross_m = done_m.y() * std::cos(path_rad) - done_m.x() * std::sin(path_rad);
    if (way_m.norm() - along_m < 10 && leg + 2 < waypoints_m.size()) ++leg;
    constexpr double kLookahead_m = 10;
    constexpr double kGamma = 0.0006;
    psi_ref_rad = path_rad - crab_rad - std::atan(cross_m / kLookahead_m);
    crab_rad += kStep_s * kGamma * kLookahead_m * cross_m / std::hypot(kLookahead_m, cross_m);
    z_ref_m = to_m.z();
  }
};

struct ClosedLoop {
  const char* file;
  std::vector<Eigen::Vector3d> waypoints_m;
  double psi_d_rad;
  double z_d_m;
  Eigen::Vector3d current_mps;
  double tolerance;
};

void ExpectClosedLoop(const ClosedLoop& run) {
  constexpr const char* kEta[] = {"x", "y", "z", "phi", "theta", "psi"};
  constexpr const char* kNu[] = {"u", "v", "w", "p", "q", "r"};
  const Remus100 auv = BuildRemus100(MunetRemus100());
  const std::vector<GoldenRow> rows = ReadGoldenCsv(run.file);
  Remus100State state;
  for (int i = 0; i < 6; ++i) {
    state.eta[i] = Number(rows.front(), kEta[i]);
    state.nu[i] = Number(rows.front(), kNu[i]);
  }
  state.actuators.propeller_rpm = Number(rows.front(), "rpm_act");
  AuvPilot pilot(MunetRemusPilot());
  pilot.Start(run.psi_d_rad, run.z_d_m);
  MunetPath path{.waypoints_m = run.waypoints_m};
  int step = 0;
  for (const GoldenRow& row : rows) {
    for (; step <= static_cast<int>(Number(row, "i")); ++step) {
      const bool is_compared = step == static_cast<int>(Number(row, "i"));
      for (int i = 0; is_compared && i < 6; ++i) {
        const double golden = Number(row, kEta[i]);
        const double difference = state.eta[i] - golden;
        ASSERT_NEAR(i < 3 ? difference : WrapPi(difference), 0,
                    run.tolerance * std::max(1.0, std::abs(golden)))
            << run.file << " step " << step << " " << kEta[i];
        ASSERT_NEAR(state.nu[i], Number(row, kNu[i]), run.tolerance)
            << run.file << " step " << step << " " << kNu[i];
      }
      path.Update(state);
      const AuvDeflections fins =
          pilot.KeepHeadingAndDepth(MotionOf(state), path.psi_ref_rad, path.z_ref_m, {}, kStep_s);
      if (is_compared) {
        ASSERT_NEAR(fins.rudder_rad, Number(row, "rud_cmd"), 100 * run.tolerance) << step;
        ASSERT_NEAR(fins.stern_plane_rad, Number(row, "stern_cmd"), 100 * run.tolerance) << step;
        ASSERT_NEAR(pilot.desired_z_m(), Number(row, "z_d"), 100 * run.tolerance) << step;
      }
      const Remus100Actuators command = {fins.rudder_rad, fins.stern_plane_rad,
                                         Number(rows.front(), "rpm_cmd")};
      state = Step(auv, state, command, {.current_mps = run.current_mps}, kStep_s);
    }
  }
  EXPECT_GT(step, 2900);
}

TEST(PitchOfDescent, IsThatOfTheWayThroughTheSea) {
  EXPECT_NEAR(PitchOfDescent(1, 2), -kPi / 6, 1e-12) << "bow down";
  EXPECT_NEAR(PitchOfDescent(-1, 2), kPi / 6, 1e-12);
  EXPECT_EQ(PitchOfDescent(0.25, 0.1), PitchOfDescent(0.25, 0.5)) << "fins do not lift";
  EXPECT_NEAR(PitchOfDescent(9, 2), -kPi / 2, 1e-12);
}

TEST(DefaultPilot, TakesADepthThatMovesAsItIsAndPitchesWithIt) {
  AuvPilot pilot(DefaultRemusPilot());
  pilot.Start(0, 20);
  const AuvMotion motion{.z_m = 20, .speed_mps = 2};
  (void)pilot.KeepHeadingAndDepth(motion, 0, 20, {}, kStep_s, -0.2);
  EXPECT_NEAR(pilot.desired_theta_rad(), -0.2, 1e-12);
  (void)pilot.KeepHeadingAndDepth(motion, 0, 21, {}, kStep_s, -0.2);
  EXPECT_EQ(pilot.desired_z_m(), 21) << "not filtered";
  (void)pilot.KeepHeadingAndDepth(motion, 0, 21, {}, kStep_s);
  EXPECT_EQ(pilot.desired_z_m(), 21) << "the filter goes on from there";
}

TEST(MunetPilot, ChangesDepthAsItsOriginal) {
  ExpectClosedLoop({.file = "munet/remus_step_depth.csv",
                    .waypoints_m = {{0, 0, 40}, {3000, 0, 40}},
                    .psi_d_rad = 0,
                    .z_d_m = 20,
                    .current_mps = Eigen::Vector3d::Zero(),
                    .tolerance = 1e-8});
}

TEST(MunetPilot, ChangesHeadingAsItsOriginal) {
  ExpectClosedLoop({.file = "munet/remus_step_heading.csv",
                    .waypoints_m = {{0, 0, 30}, {2000, 2000, 30}},
                    .psi_d_rad = 0,
                    .z_d_m = 30,
                    .current_mps = Eigen::Vector3d::Zero(),
                    .tolerance = 1e-8});
}

TEST(MunetPilot, FollowsASquareInACurrentAsItsOriginal) {
  const double component_mps = 0.3 * std::sqrt(0.5);
  ExpectClosedLoop(
      {.file = "munet/remus_pf_square_current.csv",
       .waypoints_m = {{0, 0, 20}, {150, 0, 20}, {150, 150, 30}, {0, 150, 30}, {0, 0, 20}},
       .psi_d_rad = 0,
       .z_d_m = 20,
       .current_mps = {component_mps, component_mps, 0},
       .tolerance = 1e-6});
}

/// What a step of heading or depth looks like.
struct Response {
  double overshoot = 0;  ///< Beyond the goal, by the size of the step.
  double settled_s = 0;  ///< From then on within 2 % of the goal.
  double final_error = 0;
  double noise_rad = 0;  ///< Travel of the fins in the last 10 s.
};

constexpr double kStart_s = 10;

Response RunStep(const Remus100Params& params, double rpm, double period_s, double psi_step_rad,
                 double z_step_m, double duration_s) {
  const Remus100 auv = BuildRemus100(params);
  AuvPilot pilot(DefaultRemusPilot());
  Remus100State state;
  state.eta[2] = 30;
  pilot.Start(0, 30);
  Response response;
  AuvDeflections fins;
  const auto steps_per_update = std::lround(period_s / kStep_s);
  const double step_size = psi_step_rad != 0 ? psi_step_rad : z_step_m;
  const double end_s = kStart_s + duration_s;
  for (int i = 0; i * kStep_s < end_s; ++i) {
    const double time_s = i * kStep_s;
    const bool has_begun = time_s >= kStart_s;
    const AuvDeflections before = fins;
    if (i % steps_per_update == 0) {
      fins = pilot.KeepHeadingAndDepth(MotionOf(state), has_begun ? psi_step_rad : 0,
                                       has_begun ? 30 + z_step_m : 30, {}, period_s);
    }
    state = Step(auv, state, {fins.rudder_rad, fins.stern_plane_rad, rpm}, {}, kStep_s);
    if (!has_begun) continue;
    const double reached = psi_step_rad != 0 ? state.eta[5] : state.eta[2] - 30;
    const double share = reached / step_size;
    response.overshoot = std::max(response.overshoot, share - 1);
    if (std::abs(share - 1) > 0.02) response.settled_s = time_s - kStart_s;
    response.final_error = share - 1;
    if (time_s > end_s - 10) {
      response.noise_rad += std::abs(fins.rudder_rad - before.rudder_rad) +
                            std::abs(fins.stern_plane_rad - before.stern_plane_rad);
    }
  }
  return response;
}

// At slow, cruising and top speed, updated in every step of the model and at a slow helm's pace.
TEST(DefaultPilot, TurnsWithoutMuchOvershootAndSettles) {
  for (const Remus100Params& params : {Remus100Params{}, FossenRemus100()}) {
    for (const double rpm : {700.0, 1200.0, 1525.0}) {
      for (const double period_s : {0.02, 0.2}) {
        const Response response = RunStep(params, rpm, period_s, 1.5, 0, 60);
        const std::string where = std::to_string(rpm) + " rpm, " + std::to_string(period_s) + " s";
        EXPECT_LT(response.overshoot, 0.1) << where;
        EXPECT_LT(response.settled_s, 55) << where;
        EXPECT_NEAR(response.final_error, 0, 0.015) << where;
        EXPECT_LT(response.noise_rad, 0.05) << where;
      }
    }
  }
}

TEST(DefaultPilot, DivesWithoutMuchOvershootAndSettles) {
  for (const double rpm : {700.0, 1200.0, 1525.0}) {
    for (const double period_s : {0.02, 0.2}) {
      const Response response = RunStep({}, rpm, period_s, 0, 20, 160);
      const std::string where = std::to_string(rpm) + " rpm, " + std::to_string(period_s) + " s";
      EXPECT_LT(response.overshoot, 0.05) << where;
      EXPECT_LT(response.settled_s, 140) << where;
      EXPECT_NEAR(response.final_error, 0, 0.02) << where;
      EXPECT_LT(response.noise_rad, 0.05) << where;
    }
  }
}

TEST(DefaultPilot, KeepsTheDirectionOfTargetTracking) {
  const Remus100 auv = BuildRemus100({});
  AuvPilot pilot(DefaultRemusPilot());
  Remus100State state;
  state.eta[2] = 50;
  pilot.Start(0, 50);
  for (int i = 0; i < 3000; ++i) {
    const AuvDeflections fins = pilot.KeepHeadingAndPitch(MotionOf(state), -2, 0.15, {}, kStep_s);
    state = Step(auv, state, {fins.rudder_rad, fins.stern_plane_rad, 1200}, {}, kStep_s);
  }
  EXPECT_NEAR(state.eta[5], -2, 0.01);
  EXPECT_NEAR(state.eta[4], 0.15, 0.01);
}

}  // namespace shoal::auv_pilot_test
