// Velocity layers, cascade, constant bearing and depth safety against MuNet's numbers
// (tests/golden/munet). Rows in which MuNet is wrong are marked with the fault that explains them,
// by its number in the notes on MuNet.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/plausible.h"
#include "lib/vehicle/guidance/target_tracker.h"
#include "tests/golden/read_golden.h"

namespace shoal::velocity_golden_test {

using Eigen::Vector3d;

Vector3d Vector(const GoldenRow& row, const std::string& prefix, const std::string& infix = "") {
  return {Number(row, prefix + infix + "x"), Number(row, prefix + infix + "y"),
          Number(row, prefix + infix + "z")};
}

Vector3d Vector(const nlohmann::json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

testing::AssertionResult Equal(const Vector3d& value, const Vector3d& golden) {
  if ((value - golden).norm() <= 1e-12 * std::max(1.0, golden.norm())) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << value.transpose() << " is not " << golden.transpose();
}

// Reads members m1, m2 ... of a row.
std::vector<Neighbour> Members(const GoldenRow& row) {
  std::vector<Neighbour> members;
  const int count = static_cast<int>(Number(row, "n"));
  for (int i = 1; i <= count; ++i) {
    members.push_back({.id = 100 + i, .position_m = Vector(row, "m" + std::to_string(i) + "_")});
  }
  return members;
}

TEST(FormationGolden, ZonesAreThoseOfMunet) {
  int num_coincident = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/apf_formation.csv")) {
    const FormationLayer layer{.r_safe_m = Number(row, "r_safe"),
                               .r_inner_m = Number(row, "r_inner"),
                               .r_follow_m = Number(row, "r_follow")};
    const double u_max_mps = Number(row, "u_max");
    const Surroundings around{.own = {.id = 1, .position_m = Vector(row, "")},
                              .target = Neighbour{.id = 0, .position_m = Vector(row, "t_")}};
    const Vector3d v_mps = LayerVelocity(layer, u_max_mps, around);
    if (Number(row, "r") < 1e-6) {  // MuNet does not part vehicles that coincide.
      ++num_coincident;
      EXPECT_NEAR(v_mps.norm(), u_max_mps, 1e-12);
      continue;
    }
    EXPECT_TRUE(Equal(v_mps, Vector(row, "out_", "v"))) << "r = " << row.at("r");
  }
  EXPECT_GT(num_coincident, 0);
}

TEST(SurvivalGroupGolden, RepulsionIsThatOfMunet) {
  int num_coincident = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/apf_survival_group.csv")) {
    const SurvivalGroupLayer layer{.r_safe_m = Number(row, "r_safe"),
                                   .r_avoid_m = Number(row, "r_avoid")};
    const double u_max_mps = Number(row, "u_max");
    std::vector<Neighbour> members = Members(row);
    const Vector3d own_m = Vector(row, "");
    const auto coincides = [&](const Neighbour& member) {
      return (member.position_m - own_m).norm() < 1e-6;
    };
    if (members.size() == 1 && coincides(members[0])) {  // As above.
      ++num_coincident;
      const Surroundings around{.own = {.position_m = own_m}, .group = members};
      EXPECT_NEAR(LayerVelocity(layer, u_max_mps, around).norm(), u_max_mps, 1e-12);
    }
    std::erase_if(members, coincides);
    const Surroundings around{.own = {.position_m = own_m}, .group = members};
    EXPECT_TRUE(Equal(LayerVelocity(layer, u_max_mps, around), Vector(row, "out_", "v")));
  }
  EXPECT_GT(num_coincident, 0);
}

TEST(SurvivalSonarGolden, IsThatOfMunetForOneBeamAndItsDirectionForMany) {
  int num_same = 0;
  int num_weaker = 0;
  for (const auto& scene : ReadGoldenJson("munet/apf_fls_composite.json")) {
    std::vector<SonarEcho> echoes;
    int num_near = 0;
    for (size_t i = 0; i < scene["ranges"].size(); ++i) {
      echoes.push_back({.direction = Vector(scene["dirs"][i]), .range_m = scene["ranges"][i]});
      if (echoes.back().range_m < scene["r_fls"]) ++num_near;
    }
    std::vector<Neighbour> members;
    for (const auto& member : scene["members"]) {
      members.push_back({.id = 5, .position_m = Vector(member)});
    }
    const Surroundings around{
        .own = {.position_m = Vector(scene["own"])}, .group = members, .sonar = echoes};
    const SurvivalLayer layer{.group = {.r_safe_m = scene["r_safe"], .r_avoid_m = scene["r_avoid"]},
                              .sonar = {.r_avoid_m = scene["r_fls"]}};
    const double u_max_mps = scene["u_max"];
    const Vector3d sonar_mps = LayerVelocity(layer.sonar, u_max_mps, around);
    const Vector3d group_mps = LayerVelocity(layer.group, u_max_mps, around);
    EXPECT_TRUE(Equal(group_mps, Vector(scene["group_out"])));
    EXPECT_TRUE(Equal(LayerVelocity(layer, u_max_mps, around),
                      ClampNorm(sonar_mps + group_mps, u_max_mps)));
    const Vector3d munet_mps = Vector(scene["fls_out"]);
    if (num_near <= 1) {
      ++num_same;
      EXPECT_TRUE(Equal(sonar_mps, munet_mps));
      EXPECT_TRUE(Equal(LayerVelocity(layer, u_max_mps, around), Vector(scene["composite_out"])));
    } else {  // MuNet's sum grows with the number of beams.
      num_weaker += sonar_mps.norm() < munet_mps.norm() - 1e-9;
      EXPECT_LE(sonar_mps.norm(), munet_mps.norm() + 1e-12);
      EXPECT_TRUE(Equal(sonar_mps.normalized(), munet_mps.normalized()));
    }
  }
  EXPECT_GT(num_same, 0);
  EXPECT_GT(num_weaker, 0);
}

TEST(DepthSafetyGolden, BrakesAsMunetDoes) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/depthSafetyLimit.csv")) {
    const DepthSafety limits{.z_max_m = Number(row, "z_max"), .z_safe_m = Number(row, "z_safe")};
    const Vector3d limited_mps = ApplyDepthSafety(limits, Number(row, "seabed_z"), Number(row, "z"),
                                                  Number(row, "own_vz"), Vector(row, "cmd_", "v"));
    EXPECT_TRUE(Equal(limited_mps, Vector(row, "out_", "v"))) << "z = " << row.at("z");
  }
}

// MuNet's speed to rpm map of its Remus 100.
double MunetRpm(double speed_mps) {
  if (speed_mps <= 0.0605) return 1636.37 * speed_mps;
  if (speed_mps <= 0.6383) return 508.411 * speed_mps + 69.2435;
  return 590.939 * speed_mps + 16.1836;
}

TEST(CascadeGolden, WeighsAndCommandsAsMunetDoes) {
  const TargetTrackParams params{.law = VelocityCascade{}, .max_pitch_rad = kPi / 2};
  for (const GoldenRow& row : ReadGoldenCsv("munet/apf_cascade.csv")) {
    const std::vector<Neighbour> members = Members(row);
    const Neighbour own{
        .id = 1, .position_m = Vector(row, ""), .velocity_mps = Vector(row, "own_", "v")};
    const Neighbour target{
        .id = 0, .position_m = Vector(row, "t_"), .velocity_mps = Vector(row, "t_", "v")};
    const Surroundings around{.own = own, .target = target, .group = members};
    EXPECT_TRUE(Equal(LayerVelocity(SurvivalLayer{}, 2.5, around), Vector(row, "ca_", "v")));
    EXPECT_TRUE(Equal(LayerVelocity(FormationLayer{}, 2.5, around), Vector(row, "fk_", "v")));
    EXPECT_TRUE(Equal(LayerVelocity(FeedForwardLayer{}, 2.5, around), Vector(row, "mi_", "v")));
    TargetTracker tracker(params, 0);
    const TrackCommand command = tracker.Update(around);
    EXPECT_TRUE(Equal(command.velocity_mps, Vector(row, "out_", "v")));
    EXPECT_NEAR(command.psi_d_rad, Number(row, "psi_d"), 1e-11);
    EXPECT_NEAR(command.theta_d_rad, Number(row, "theta_d"), 1e-11);
    EXPECT_NEAR(command.Rpm(MunetRpm), Number(row, "rpm_cmd"), 1e-8);
  }
}

// Returns the greatest speed along `direction` that a vehicle which also moves as its target can
// have, the law of cosines written as in MuNet's text.
double SpeedBudget(const Vector3d& v_t_mps, const Vector3d& direction, double u_max_mps) {
  const double along_mps = v_t_mps.dot(direction);
  return -along_mps +
         std::sqrt(along_mps * along_mps - v_t_mps.squaredNorm() + u_max_mps * u_max_mps);
}

// The column doc_v solves the velocity triangle for the direction to the target, also inside r_safe
// where the vehicle moves the other way. It then asks for up to twice u_max when the target comes
// nearer, and for nothing when the target leaves at u_max. The triangle belongs to the direction of
// motion: there ours differs from doc_v, by U_a alone.
TEST(ConstantBearingGolden, FollowsTheDocumentedLaw) {
  int num_outside = 0;
  int num_inside = 0;
  int num_unlike_munet = 0;  // It closes in inside r_safe, ignores a target at rest.
  int num_too_fast = 0;
  for (const GoldenRow& row : ReadGoldenCsv("munet/velCB_grid.csv")) {
    const Vector3d offset_m = Vector(row, "") - Vector(row, "t_");
    const Vector3d v_t_mps = Vector(row, "t_", "v");
    const double u_max_mps = Number(row, "u_max");
    const ConstantBearingLaw law{.lookahead_m = Number(row, "Delta"),
                                 .r_safe_m = Number(row, "r_safe")};
    const Neighbour target{
        .id = 0, .position_m = Vector(row, "t_"), .velocity_mps = Vector(row, "t_", "v")};
    const Surroundings around{.own = {.id = 1, .position_m = Vector(row, "")}, .target = target};
    const Vector3d v_mps = DesiredVelocity(law, u_max_mps, around);
    EXPECT_TRUE(v_mps.allFinite());
    EXPECT_LE(v_mps.norm(), u_max_mps * (1 + 1e-12));

    const Vector3d doc_mps = Vector(row, "doc_", "v");
    if (offset_m.norm() == 0 || v_t_mps.norm() > u_max_mps) {
      ++num_too_fast;
      continue;
    }
    num_unlike_munet += !Equal(v_mps, Vector(row, "peer_", "v"));
    if (offset_m.norm() >= law.r_safe_m) {
      ++num_outside;
      EXPECT_TRUE(Equal(v_mps, ClampNorm(doc_mps, u_max_mps)))
          << "r = " << offset_m.norm() << " v_t = " << v_t_mps.transpose();
      continue;
    }
    ++num_inside;
    const Vector3d los = offset_m.normalized();
    const double gap_m = law.r_safe_m - offset_m.norm();
    const double share = gap_m / std::hypot(law.lookahead_m, gap_m);
    EXPECT_TRUE(Equal(doc_mps, v_t_mps + SpeedBudget(v_t_mps, -los, u_max_mps) * share * los));
    EXPECT_TRUE(Equal(v_mps, v_t_mps + SpeedBudget(v_t_mps, los, u_max_mps) * share * los));
    EXPECT_GE((v_mps - v_t_mps).dot(los), 0);
  }
  EXPECT_GT(num_outside, 300);
  EXPECT_GT(num_inside, 50);
  EXPECT_GT(num_unlike_munet, num_inside / 2);
  EXPECT_GT(num_too_fast, 0);
}

}  // namespace shoal::velocity_golden_test
