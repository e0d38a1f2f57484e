// muNet's closed loops of path following, by shoal's laws: nothing in these runs is a fault that
// shoal does not rebuild, so that all of each run is compared.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/closed_loops/golden_track.h"
#include "tests/closed_loops/munet_auv.h"

namespace shoal::path_following_test {

struct PathRun {
  std::string file;
  std::vector<Eigen::Vector3d> waypoints_m;
  double rpm = 1200;
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();
};

/// 1e-8 for 30 s and 1e-6 to the end, as the golden data's README has it.
double ToleranceAt(int64_t step) {
  return static_cast<double>(step) * kMunetStep_s <= 30 ? 1e-8 : 1e-6;
}

void ExpectSameRun(const PathRun& run) {
  const GoldenTracks golden = ReadTracks(run.file);
  const GoldenRow& first = golden.begin()->second.front();
  MunetAuv auv(StateIn(first), Number(first, "psi"), Number(first, "z"));
  auv.TakePath(run.waypoints_m, run.rpm);
  size_t num_compared = 0;
  for (int64_t step = 0; step <= golden.rbegin()->first; ++step) {
    const Remus100State before = auv.state;
    auv.DecideOnPath();
    if (const auto found = golden.find(step); found != golden.end()) {
      const GoldenRow& row = found->second.front();
      const double tolerance = ToleranceAt(step);
      const std::string where = run.file + " step " + std::to_string(step);
      ExpectState(before, row, tolerance, where);
      EXPECT_NEAR(auv.path_guidance.y_e_m, Number(row, "y_e"), 100 * tolerance) << where;
      EXPECT_NEAR(WrapPi(auv.path_guidance.psi_ref_rad - Number(row, "psi_ref")), 0, tolerance)
          << where;
      EXPECT_NEAR(auv.path_guidance.crab_rad, Number(row, "beta_c_hat"), tolerance) << where;
      EXPECT_NEAR(auv.pilot.desired_z_m(), Number(row, "z_d"), 100 * tolerance) << where;
      EXPECT_NEAR(auv.command.rudder_rad, Number(row, "rud_cmd"), 100 * tolerance) << where;
      EXPECT_NEAR(auv.command.stern_plane_rad, Number(row, "stern_cmd"), 100 * tolerance) << where;
      EXPECT_EQ(static_cast<double>(auv.leg), Number(row, "wpt_k")) << where;
      ++num_compared;
      if (testing::Test::HasFailure()) return;
    }
    auv.Step({.current_mps = run.current_mps});
  }
  EXPECT_GT(num_compared, 40U);
}

const std::vector<Eigen::Vector3d> kSquare_m = {
    {0, 0, 20}, {150, 0, 20}, {150, 150, 30}, {0, 150, 30}, {0, 0, 20}};

Eigen::Vector3d Toward(double speed_mps, double psi_rad) {
  return {speed_mps * std::cos(psi_rad), speed_mps * std::sin(psi_rad), 0};
}

TEST(PathFollowingAsMunet, GoesRoundASquareInStillWater) {
  ExpectSameRun({.file = "munet/remus_pf_square_nocurrent.csv", .waypoints_m = kSquare_m});
}

TEST(PathFollowingAsMunet, GoesRoundASquareInACurrent) {
  ExpectSameRun({.file = "munet/remus_pf_square_current.csv",
                 .waypoints_m = kSquare_m,
                 .current_mps = Toward(0.3, kPi / 4)});
}

TEST(PathFollowingAsMunet, CrabsAlongAStraightPathInACurrentFromTheSide) {
  ExpectSameRun({.file = "munet/remus_pf_straight_current.csv",
                 .waypoints_m = {{0, 0, 25}, {200, 0, 25}, {1000, 0, 25}},
                 .rpm = 1300,
                 .current_mps = Toward(0.5, kPi / 2)});
}

TEST(PathFollowingAsMunet, GoesOnPastTheEndOfItsPath) {
  ExpectSameRun({.file = "munet/remus_pf_endofpath.csv",
                 .waypoints_m = {{0, 0, 15}, {60, 0, 20}, {90, 80, 25}},
                 .rpm = 1000});
}

}  // namespace shoal::path_following_test
