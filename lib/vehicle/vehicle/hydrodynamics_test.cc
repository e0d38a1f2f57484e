#include "lib/vehicle/vehicle/hydrodynamics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/attitude.h"
#include "lib/vehicle/vehicle/remus100_params.h"
#include "tests/golden/read_golden.h"

namespace shoal::hydrodynamics_test {

constexpr double kRho = 1026;
constexpr double kCd = 1.2;

CrossFlowHull Hull(StripRule rule) {
  return {.length_m = 1.6,
          .draught_m = 0.19,
          .drag_coefficient = kCd,
          .density_kgpm3 = kRho,
          .rule = rule};
}

double Thousandths(int from, int to) { return *rc::gen::inRange(from, to) / 1000.0; }

TEST(CrossFlowDrag, GivesTheClosedFormInPureSway) {
  for (const double v_mps : {-0.7, 0.2, 1.5}) {
    const CrossFlowForce force = CrossFlowDrag(Hull(StripRule::kMidpoint), v_mps, 0);
    const double closed_n = -0.5 * kRho * 0.19 * kCd * std::abs(v_mps) * v_mps * 1.6;
    EXPECT_NEAR(force.sway_n / closed_n, 1, 1e-12);
    EXPECT_NEAR(force.yaw_nm, 0, 1e-12);
  }
}

TEST(CrossFlowDrag, GivesTheClosedFormInPureYaw) {
  for (const double r_radps : {-0.5, 0.3}) {
    const CrossFlowForce force = CrossFlowDrag(Hull(StripRule::kMidpoint), 0, r_radps);
    const double closed_nm =
        -0.5 * kRho * 0.19 * kCd * std::abs(r_radps) * r_radps * std::pow(1.6, 4) / 32;
    EXPECT_NEAR(force.yaw_nm / closed_nm, 1, 0.006);  // Twenty strips.
    EXPECT_NEAR(force.sway_n, 0, 1e-12);
  }
}

TEST(CrossFlowDrag, IsTooLargeByAStationWhenBothEndsAreCounted) {
  const CrossFlowForce right = CrossFlowDrag(Hull(StripRule::kMidpoint), 1, 0);
  const CrossFlowForce published = CrossFlowDrag(Hull(StripRule::kBothEnds), 1, 0);
  EXPECT_NEAR(published.sway_n / right.sway_n, 21.0 / 20, 1e-12);
}

TEST(CrossFlowDrag, MatchesThePublishedTable) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/gnc_drag.csv")) {
    const CrossFlowHull hull = {.length_m = Number(row, "L"),
                                .draught_m = Number(row, "T"),
                                .drag_coefficient = Number(row, "Cd2D"),
                                .density_kgpm3 = kRho,
                                .rule = StripRule::kBothEnds};
    const CrossFlowForce force = CrossFlowDrag(hull, Number(row, "vr"), Number(row, "r"));
    EXPECT_NEAR(force.sway_n, Number(row, "Ycf"), 1e-12 * std::abs(Number(row, "Ycf")));
    EXPECT_NEAR(force.yaw_nm, Number(row, "Ncf"), 1e-12 * std::abs(Number(row, "Ncf")));
  }
}

RC_GTEST_PROP(CrossFlowDrag, TakesPowerFromEveryMotion, ()) {
  const double v_mps = Thousandths(-2000, 2001);
  const double r_radps = Thousandths(-2000, 2001);
  const CrossFlowForce force = CrossFlowDrag(Hull(StripRule::kMidpoint), v_mps, r_radps);
  RC_ASSERT(force.sway_n * v_mps + force.yaw_nm * r_radps <= 1e-12);
}

WingHull Wing(LiftLaw law) {
  WingHull wing = BuildRemus100({}).wing;
  wing.law = law;
  return wing;
}

TEST(LiftDrag, MatchesThePublishedTable) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/gnc_drag.csv")) {
    WingHull wing = Wing(LiftLaw::kLinear);
    wing.span_m = Number(row, "B");
    wing.area_m2 = 0.7 * Number(row, "L") * Number(row, "B");
    wing.parasitic_drag = Number(row, "CD0");
    const LiftDragForce force = LiftDrag(wing, Number(row, "alpha"), Number(row, "Ur"));
    EXPECT_NEAR(force.surge_n, Number(row, "Xld"), 1e-12 * std::abs(Number(row, "Xld")));
    EXPECT_NEAR(force.heave_n, Number(row, "Zld"), 1e-12 * std::abs(Number(row, "Zld")));
  }
}

TEST(LiftDrag, IsTheSameByBothLawsAtSmallAngles) {
  for (const double alpha_rad : {-0.1, 0.02, 0.1}) {
    const LiftDragForce slender = LiftDrag(Wing(LiftLaw::kSlender), alpha_rad, 2);
    const LiftDragForce linear = LiftDrag(Wing(LiftLaw::kLinear), alpha_rad, 2);
    EXPECT_NEAR(slender.surge_n / linear.surge_n, 1, 0.01);
    EXPECT_NEAR(slender.heave_n / linear.heave_n, 1, 0.01);
  }
}

RC_GTEST_PROP(LiftDrag, IsMirroredAsternByTheSlenderLaw, ()) {
  const double u_mps = Thousandths(-2000, 2001);
  const double w_mps = Thousandths(-2000, 2001);
  const double speed_mps = std::hypot(u_mps, w_mps);
  const WingHull wing = Wing(LiftLaw::kSlender);
  const LiftDragForce ahead = LiftDrag(wing, std::atan2(w_mps, u_mps), speed_mps);
  const LiftDragForce astern = LiftDrag(wing, std::atan2(w_mps, -u_mps), speed_mps);
  RC_ASSERT(std::abs(ahead.surge_n + astern.surge_n) < 1e-9);
  RC_ASSERT(std::abs(ahead.heave_n - astern.heave_n) < 1e-9);
}

RC_GTEST_PROP(LiftDrag, TakesPowerFromEveryMotion, (bool is_linear)) {
  const double u_mps = Thousandths(-2000, 2001);
  const double w_mps = Thousandths(-2000, 2001);
  const LiftDragForce force = LiftDrag(Wing(is_linear ? LiftLaw::kLinear : LiftLaw::kSlender),
                                       std::atan2(w_mps, u_mps), std::hypot(u_mps, w_mps));
  RC_ASSERT(force.surge_n * u_mps + force.heave_n * w_mps <= 1e-9);
}

RC_GTEST_PROP(CoriolisMatrix, DoesNoWork, ()) {
  const Remus100 auv = BuildRemus100({});
  Vector6d nu;
  for (double& value : nu) value = Thousandths(-3000, 3001);
  RC_ASSERT(std::abs(nu.dot(CoriolisMatrix(auv.mass, nu) * nu)) < 1e-9);
}

TEST(LambFactors, ApproachThoseOfASphereAndOfALongCylinder) {
  const LambFactors sphere = LambFactorsOfSpheroid(1.001, 1);
  EXPECT_NEAR(sphere.surge, 0.5, 0.001);
  EXPECT_NEAR(sphere.sway, 0.5, 0.001);
  EXPECT_NEAR(sphere.yaw, 0, 0.001);
  const LambFactors needle = LambFactorsOfSpheroid(100, 1);
  EXPECT_NEAR(needle.surge, 0, 0.001);
  EXPECT_NEAR(needle.sway, 1, 0.001);
  EXPECT_NEAR(needle.yaw, 1, 0.003);
}

TEST(Attitude, MatchesThePublishedTable) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/gnc_rotations_gvect.csv")) {
    const double phi = Number(row, "phi");
    const double theta = Number(row, "theta");
    const Eigen::Matrix3d rotation = BodyToWorld(phi, theta, Number(row, "psi"));
    const Eigen::Matrix3d rates = BodyRatesToEulerRates(phi, theta);
    const Vector6d g = Restoring({.weight_n = Number(row, "W"),
                                  .buoyancy_n = Number(row, "B"),
                                  .cg_m = Eigen::Vector3d(0, 0, 0.02)},
                                 phi, theta);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const std::string cell = std::to_string(i) + std::to_string(j);
        EXPECT_NEAR(rotation(i, j), Number(row, "R" + cell), 1e-14);
        EXPECT_NEAR(rates(i, j), Number(row, "T" + cell), 1e-13);
      }
    }
    for (int i = 0; i < 6; ++i) {
      const double golden = Number(row, "g" + std::to_string(i));
      EXPECT_NEAR(g[i], golden, 1e-12 * (1 + std::abs(golden))) << i;
    }
  }
}

RC_GTEST_PROP(Attitude, IsTheSameAfterNormalizing, ()) {
  const Eigen::Vector3d angles(Thousandths(-9000, 9001), Thousandths(-9000, 9001),
                               Thousandths(-9000, 9001));
  const Eigen::Vector3d normal = NormalizeEuler(angles);
  RC_ASSERT(std::abs(normal[0]) <= kPi);
  RC_ASSERT(std::abs(normal[1]) <= kPi / 2);
  RC_ASSERT(std::abs(normal[2]) <= kPi);
  RC_ASSERT(BodyToWorld(angles[0], angles[1], angles[2])
                .isApprox(BodyToWorld(normal[0], normal[1], normal[2]), 1e-12));
}

TEST(SubmergedShare, GrowsSmoothlyFromNoneToAllAcrossTheSurface) {
  EXPECT_EQ(SubmergedShare(-0.1, 0.2), 0);
  EXPECT_EQ(SubmergedShare(-5, 0.2), 0);
  EXPECT_NEAR(SubmergedShare(0, 0.2), 0.5, 1e-12);
  EXPECT_EQ(SubmergedShare(0.1, 0.2), 1);
  EXPECT_EQ(SubmergedShare(50, 0.2), 1);
  // A sphere's cap of height h has the volume pi h^2 (3 r - h) / 3.
  const double h = 0.05, r = 0.1;
  EXPECT_NEAR(SubmergedShare(-0.05, 0.2),
              kPi * h * h * (3 * r - h) / 3 / (4.0 / 3.0 * kPi * r * r * r), 1e-12);
}

}  // namespace shoal::hydrodynamics_test
