// Paths, waypoint switching and ALOS against MuNet's numbers (tests/golden/munet).
#include <gtest/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/alos.h"
#include "lib/vehicle/guidance/path_progress.h"
#include "tests/golden/read_golden.h"

namespace shoal::path_golden_test {

constexpr double kRelative = 1e-12;

Eigen::Vector3d Vector(const GoldenRow& row, const std::string& x, const std::string& y,
                       const std::string& z) {
  return {Number(row, x), Number(row, y), Number(row, z)};
}

void ExpectNear(double value, double golden, double scale) {
  EXPECT_NEAR(value, golden, kRelative * std::max({1.0, std::abs(golden), std::abs(scale)}));
}

WaypointPath PathOf(const nlohmann::json& points) {
  WaypointPath path;
  for (const auto& point : points) path.points_m.emplace_back(point[0], point[1], point[2]);
  return path;
}

TEST(AlosGolden, ErrorsHeadingAndCrabAngleAreThoseOfMunet) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/alos_grid.csv")) {
    const Eigen::Vector3d from_m(Number(row, "x1"), Number(row, "y1"), 0);
    const Eigen::Vector3d to_m(Number(row, "x2"), Number(row, "y2"), 0);
    const Eigen::Vector3d position_m(Number(row, "x"), Number(row, "y"), 0);
    const WaypointPath path{{from_m, to_m}};
    const PathLeg leg = CurrentLeg(path, PathEnd::kGoOn, {}, position_m);
    const TrackErrors errors = ErrorsOn(leg, position_m);
    ExpectNear(leg.psi_rad, Number(row, "pi_h"), 1);
    ExpectNear(errors.x_e_m, Number(row, "x_e"), position_m.norm());
    ExpectNear(errors.y_e_m, Number(row, "y_e"), position_m.norm());

    const AlosParams params{.lookahead_m = Number(row, "Delta"), .crab_gain = Number(row, "gamma")};
    const AlosStep step = StepAlos(params, leg.psi_rad, Number(row, "y_e"),
                                   Number(row, "beta_c_hat"), Number(row, "h"));
    // MuNet does not wrap psi_ref, although its text states the range [-pi, pi].
    ExpectNear(WrapPi(step.heading_rad - Number(row, "psi_ref")), 0, 1);
    ExpectNear(step.crab_rad, Number(row, "n_beta_c_hat"), 1);
  }
}

class UpdateWptGolden : public testing::Test {
 protected:
  const nlohmann::json facts_ = ReadGoldenJson("munet/waypoint_path_functions.json");
  const WaypointPath path_ = PathOf(facts_["updateWpt_waypoints"]);
  const std::vector<GoldenRow> rows_ = ReadGoldenCsv("munet/updateWpt.csv");

  PathProgress ProgressOf(const GoldenRow& row) const {
    PathProgress progress;
    progress.previous = static_cast<size_t>(Number(row, "wpt_k"));
    progress.ended = progress.previous + 1 == path_.points_m.size();
    return progress;
  }
};

TEST_F(UpdateWptGolden, AlongTrackRuleSwitchesWhereMunetDoes) {
  const WaypointSwitch rule{.rule = SwitchRule::kAlongTrack,
                            .acceptance_radius_m = facts_["R_switch"]};
  for (const GoldenRow& row : rows_) {
    const Eigen::Vector3d position_m = Vector(row, "x", "y", "z");
    const PathProgress progress = ProgressOf(row);
    const PathLeg leg = CurrentLeg(path_, PathEnd::kGoOn, progress, position_m);
    EXPECT_EQ((leg.from_m - Vector(row, "prev_x", "prev_y", "prev_z")).norm(), 0);
    const Eigen::Vector3d next_m = Vector(row, "next_x", "next_y", "next_z");
    if (!progress.ended) {
      EXPECT_EQ((leg.to_m - next_m).norm(), 0);
    } else {
      // MuNet looks 1e10 m ahead of the last waypoint, we a kilometre ahead of the vehicle.
      const Eigen::Vector3d ahead = (next_m - leg.from_m).normalized();
      EXPECT_LT((leg.to_m - leg.from_m - leg.length_m * ahead).norm(), 1e-9);
    }
    const PathProgress after = Advance(path_, rule, PathEnd::kGoOn, progress, position_m);
    EXPECT_EQ(after.previous, static_cast<size_t>(Number(row, "n_wpt_k")));
  }
}

TEST_F(UpdateWptGolden, DefaultRuleDoesNotTakeAVehicleFarAbeamForArrived) {
  const WaypointSwitch rule{.acceptance_radius_m = facts_["R_switch"]};
  // MuNet switches R before the waypoint along the track, however far abeam: some of these are
  // before the line and outside the circle.
  int num_early = 0;
  for (const GoldenRow& row : rows_) {
    const Eigen::Vector3d position_m = Vector(row, "x", "y", "z");
    const PathProgress progress = ProgressOf(row);
    if (progress.ended) continue;
    const PathLeg leg = CurrentLeg(path_, PathEnd::kGoOn, progress, position_m);
    const bool munet_switches = Number(row, "n_wpt_k") > Number(row, "wpt_k");
    const bool reached = IsReached(rule, leg, position_m);
    const bool is_inside_sphere = Number(row, "inside_sphere_R_switch_of_next") == 1;
    EXPECT_TRUE(reached || !is_inside_sphere);
    EXPECT_TRUE(munet_switches || !reached);
    if (munet_switches && !reached) {
      ++num_early;
      const double distance_m = (leg.to_m - position_m).head<2>().norm();
      EXPECT_GT(distance_m, rule.acceptance_radius_m);
      const TrackErrors errors = ErrorsOn(leg, position_m);
      EXPECT_TRUE(errors.x_e_m < leg.length_m ||
                  std::abs(errors.y_e_m) > rule.passed_line_within_m);
    }
  }
  EXPECT_GT(num_early, 0);
}

TEST(WaypointPathGolden, DistancesHeadingsTimesAndAreasAreThoseOfMunet) {
  const auto facts = ReadGoldenJson("munet/waypoint_path_functions.json");
  WaypointPath path;
  for (size_t i = 0; i < facts["x"].size(); ++i) {
    path.points_m.emplace_back(facts["x"][i], facts["y"][i], facts["z"][i]);
  }
  const std::vector<double> lengths_m = LegLengths_m(path);
  const std::vector<double> psis_rad = LegPsis_rad(path);
  ASSERT_EQ(lengths_m.size(), facts["distances"].size());
  for (size_t i = 0; i < lengths_m.size(); ++i) {
    ExpectNear(lengths_m[i], facts["distances"][i], 1);
    ExpectNear(psis_rad[i], facts["headings"][i], 1);
  }
  ExpectNear(TotalLength_m(path), facts["total"], 1);
  ExpectNear(EstimateTime_s(path), facts["estimateTime_default"], 1);
  ExpectNear(EstimateTime_s(path, 1.5, 1.0), facts["estimateTime_1p5_1p0"], 1);
  const BoundingSquare area = EstimateArea(path, 300);
  EXPECT_EQ(area.side_m, facts["estimateAreaRoot_300"][0]);
  EXPECT_EQ(area.origin_m.x(), facts["right_offset_300"][0]);
  EXPECT_EQ(area.origin_m.y(), facts["right_offset_300"][1]);
  EXPECT_EQ(EstimateArea(path, 100).side_m, facts["estimateAreaRoot_100"][0]);
}

}  // namespace shoal::path_golden_test
