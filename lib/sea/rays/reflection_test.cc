#include "lib/sea/rays/reflection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace shoal::reflection_test {

constexpr double kRad = std::numbers::pi / 180;

TEST(HalfSpace, ReflectsAllBelowItsCriticalAngleAndLessAbove) {
  const HalfSpace lossless = {1650, 1.9, 0};
  const double critical_rad = std::acos(1500.0 / 1650);
  EXPECT_NEAR(Reflect(lossless, critical_rad - 0.01, {}).magnitude, 1, 1e-12);
  EXPECT_LT(Reflect(lossless, critical_rad + 0.02, {}).magnitude, 0.8);
  // Total reflection: from 180 degrees at grazing incidence to 0 at the critical angle.
  EXPECT_NEAR(Reflect(lossless, 1e-9, {}).phase_rad, std::numbers::pi, 1e-6);
  EXPECT_NEAR(Reflect(lossless, critical_rad - 1e-9, {}).phase_rad, 0, 1e-3);
  // Straight down: (Z2 - Z1) / (Z2 + Z1).
  const double impedance = 1.9 * 1650 / 1500;
  EXPECT_NEAR(Reflect(lossless, std::numbers::pi / 2, {}).magnitude,
              (impedance - 1) / (impedance + 1), 1e-12);
}

TEST(HalfSpace, ThatIsSlowLetsAllInAtOneAngle) {
  // The angle of intromission: cos^2 = (m^2 - n^2) / (m^2 - 1), m = rho2 / rho1, n = c1 / c2.
  const HalfSpace mud = {1480, 1.4, 0};
  const double n = 1500.0 / 1480;
  const double cosine = std::sqrt((1.4 * 1.4 - n * n) / (1.4 * 1.4 - 1));
  EXPECT_NEAR(Reflect(mud, std::acos(cosine), {}).magnitude, 0, 1e-12);
  EXPECT_NEAR(std::acos(cosine) / kRad, 9.7, 0.05);
}

TEST(HalfSpace, OfTheWaterItselfReturnsNothing) {
  for (const double grazing_rad : {0.0, 0.3, 1.5}) {
    EXPECT_NEAR(Reflect(HalfSpace{1500, 1, 0}, grazing_rad, {}).magnitude, 0, 1e-12);
  }
}

TEST(HalfSpace, NeverReturnsMoreThanItGets) {
  for (const auto& [name, bottom] : kBottomTypes) {
    for (int degree = 0; degree <= 90; ++degree) {
      const Reflection reflection = Reflect(bottom, degree * kRad, {});
      EXPECT_LE(reflection.magnitude, 1) << name << " " << degree;
      EXPECT_GE(reflection.magnitude, 0) << name << " " << degree;
    }
  }
  EXPECT_EQ(FindBottomType("rock")->speed_mps, 2800);
  EXPECT_FALSE(FindBottomType("lava").has_value());
}

TEST(Surface, TurnsThePhase) {
  EXPECT_EQ(Reflect(Vacuum(), 0.2, {}).magnitude, 1);
  EXPECT_EQ(Reflect(Vacuum(), 0.2, {}).phase_rad, std::numbers::pi);
  EXPECT_EQ(Reflect(RigidWall(), 0.2, {}).phase_rad, 0);
}

TEST(WindySurface, LosesMoreWithWindFrequencyAndGrazing) {
  const auto loss_db = [](double wind_mps, double grazing_deg, double hz) {
    return -20 *
           std::log10(Reflect(WindySurface{wind_mps}, grazing_deg * kRad, {.hz = hz}).magnitude);
  };
  EXPECT_EQ(loss_db(0, 5, 25'000), 0);
  // 1.26e-3 10^1.57 25^0.85 / sin 30.
  EXPECT_NEAR(loss_db(10, 30, 25'000), 1.26e-3 * std::pow(10, 1.57) * std::pow(25, 0.85) / 0.5,
              1e-9);
  EXPECT_NEAR(loss_db(5, 30, 25'000), loss_db(6, 30, 25'000) * std::exp(-1.2), 1e-9);
  EXPECT_GT(loss_db(12, 30, 25'000), loss_db(10, 30, 25'000));
  EXPECT_GT(loss_db(10, 30, 40'000), loss_db(10, 30, 25'000));
  EXPECT_GT(loss_db(10, 10, 25'000), loss_db(10, 30, 25'000));
  EXPECT_NEAR(loss_db(20, 0, 25'000), kMaxSurfaceLoss_db, 1e-9);
}

TEST(ReflectionTables, AreLinearAndReflectNothingOutsideTheirAngles) {
  const ReflectionTable table = {{{10, 1, 180}, {20, 0.5, 160}}};
  EXPECT_NEAR(Reflect(table, 15 * kRad, {}).magnitude, 0.75, 1e-12);
  EXPECT_NEAR(Reflect(table, 15 * kRad, {}).phase_rad, 170 * kRad, 1e-12);
  EXPECT_EQ(Reflect(table, 9.9 * kRad, {}).magnitude, 0);
  EXPECT_EQ(Reflect(table, 20.1 * kRad, {}).magnitude, 0);
  EXPECT_EQ(Reflect(ReflectionTable(), 0.1, {}).magnitude, 0);
  EXPECT_EQ(ProblemOf(table), "");
  EXPECT_NE(ProblemOf(ReflectionTable{{{10, 1, 0}, {10, 1, 0}}}), "");
  EXPECT_NE(ProblemOf(ReflectionTable{{{10, 1.5, 0}}}), "");
  EXPECT_NE(ProblemOf(ReflectionTable()), "");
}

}  // namespace shoal::reflection_test
